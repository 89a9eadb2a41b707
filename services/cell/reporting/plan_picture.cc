#include "services/cell/reporting/plan_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace cell::cli {
namespace {

constexpr int kRow = 26;         // [px]
constexpr int kColumn = 420;     // [px]
constexpr int kBar = 160;        // [px], of the probability 1
constexpr size_t kMaxRows = 60;  // what follows is counted

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '<') {
      escaped += "&lt;";
    } else if (c == '&') {
      escaped += "&amp;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

class Drawing {
 public:
  void Text(int x, int y, std::string_view text, std::string_view style = "") {
    body_ += fmt::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", x, y, style,
                         Escaped(text));
    bottom_ = std::max(bottom_, y);
  }
  void Box(double x, int y, double width, int height, std::string_view fill) {
    body_ += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" rx=\"4\" "
        "fill=\"{}\" stroke=\"#345\"/>\n",
        x, y, width, height, fill);
    bottom_ = std::max(bottom_, y + height);
  }
  std::string Finish() const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"sans-serif\" font-size=\"13\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n{2}</svg>\n",
        2 * kColumn + kBar, bottom_ + kRow, body_);
  }

 private:
  std::string body_;
  int bottom_ = 0;
};

constexpr std::string_view kBold = "font-weight=\"bold\"";

int DrawHeader(const PlanReport& report, Drawing* drawing) {
  const planning::Plan& plan = report.plan;
  drawing->Text(20, kRow,
                fmt::format("{} of {}: plan {}", report.problem, report.domain,
                            ToText(plan.status)),
                kBold);
  if (plan.status == planning::Plan::Status::kFound) {
    drawing->Text(
        20, 2 * kRow,
        fmt::format("probability in [{:.6g}, {:.6g}], {:.6g} actions expected",
                    plan.probability.low, plan.probability.high,
                    plan.expected_actions));
  } else {
    drawing->Text(20, 2 * kRow, plan.reason);
  }
  return 3 * kRow;
}

void DrawCourse(const planning::Plan& plan, int top, Drawing* drawing) {
  if (plan.course.empty()) return;
  drawing->Text(20, top, "most likely course", kBold);
  const size_t number = std::min(plan.course.size(), kMaxRows);
  for (size_t i = 0; i < number; ++i) {
    const planning::Step& step = plan.course[i];
    const int y = top + 8 + kRow * static_cast<int>(i);
    drawing->Box(20, y, kColumn - 60, kRow - 6,
                 step.probability < 1 ? "#fde9c4" : "#dcebf7");
    drawing->Text(28, y + 15, fmt::format("{}  {}", i + 1, step.name));
    drawing->Text(kColumn - 90, y + 15,
                  fmt::format("{:.4g}", step.probability));
  }
  if (number < plan.course.size()) {
    drawing->Text(28, top + 24 + kRow * static_cast<int>(number),
                  fmt::format("and {} more", plan.course.size() - number));
  }
}

void DrawAlternatives(const planning::Plan& plan, int top, Drawing* drawing) {
  if (plan.alternatives.empty()) return;
  drawing->Text(kColumn, top, "first actions, and the probability after each",
                kBold);
  const size_t number = std::min(plan.alternatives.size(), kMaxRows);
  for (size_t i = 0; i < number; ++i) {
    const planning::Alternative& alternative = plan.alternatives[i];
    const auto& [low, high] = alternative.probability;
    const int y = top + 8 + kRow * static_cast<int>(i);
    drawing->Box(kColumn, y, kBar * low, kRow - 6, "#9cc6e8");
    drawing->Box(kColumn + kBar * low, y, kBar * (high - low), kRow - 6,
                 "none");
    drawing->Text(
        kColumn + kBar + 10, y + 15,
        fmt::format("{}  [{:.4g}, {:.4g}]", alternative.name, low, high));
  }
}

void DrawExcuses(const PlanReport& report, int top, Drawing* drawing) {
  if (report.excuses.empty()) return;
  drawing->Text(20, top, "a plan would be possible otherwise", kBold);
  int y = top;
  for (const std::string& excuse : report.excuses) {
    size_t begin = 0;
    while (begin <= excuse.size()) {
      const size_t end = std::min(excuse.find('\n', begin), excuse.size());
      y += kRow;
      drawing->Text(begin == 0 ? 28 : 44, y, excuse.substr(begin, end - begin));
      begin = end + 1;
    }
  }
}

}  // namespace

std::string DrawPlan(const PlanReport& report) {
  Drawing drawing;
  const int top = DrawHeader(report, &drawing) + kRow / 2;
  DrawCourse(report.plan, top, &drawing);
  DrawAlternatives(report.plan, top, &drawing);
  DrawExcuses(report, top, &drawing);
  return drawing.Finish();
}

}  // namespace cell::cli
