#pragma once

#include <string>

#include "services/cell/reporting/plan_report.h"

namespace cell::cli {

/// An SVG drawing of a report: the most likely course from top to bottom, the
/// first actions with the interval of the goal's probability after each as
/// bars, and the excuse if there is no plan.
std::string DrawPlan(const PlanReport& report);

}  // namespace cell::cli
