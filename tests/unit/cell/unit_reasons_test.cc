// Reasons that systemd has, and errors in the environment of the units.
#include <gmock/gmock.h>

#include <filesystem>

#include "common/config/strict_yaml.h"
#include "services/cell/running/manager_failure.h"
#include "services/cell/running/service_units.h"
#include "services/cell/running/unit_environment.h"

namespace cell {

using namespace cli;
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

constexpr char kNoSystemd[] =
    "System has not been booted with systemd as init system (PID 1). Can't "
    "operate.\nFailed to connect to bus: Host is down\n";

TEST(ManagerFailure, WithoutSystemdItSaysSoAndWhatRunsACellThen) {
  for (const bool is_root : {false, true}) {
    const std::string text =
        Explain({.output = kNoSystemd, .is_root = is_root});
    EXPECT_THAT(text, AllOf(HasSubstr("systemd is not running here"),
                            HasSubstr("cell demo"), Not(HasSubstr("PID 1")),
                            Not(HasSubstr("root")), Not(HasSubstr("\n"))));
  }
  EXPECT_THAT(
      Explain({.output = "sh: 1: systemctl: not found\n", .exit_code = 127}),
      HasSubstr("systemd is not running here"));
}

TEST(ManagerFailure, AUserWithoutAManagerIsToldHowToGetOne) {
  EXPECT_THAT(Explain({.output = "Failed to connect to bus: No medium found\n",
                       .is_user = true}),
              AllOf(HasSubstr("loginctl enable-linger"),
                    HasSubstr("XDG_RUNTIME_DIR"), Not(HasSubstr("bus"))));
}

TEST(ManagerFailure, RootIsNotToldToBecomeRoot) {
  const ManagerFailure refused{.output = "Failed to start: Access denied\n"};
  EXPECT_THAT(Explain(refused), HasSubstr("this needs root"));
  ManagerFailure of_root = refused;
  of_root.is_root = true;
  EXPECT_THAT(Explain(of_root),
              AllOf(HasSubstr("Access denied"), Not(HasSubstr("needs root"))));
}

TEST(ManagerFailure, ACellThatIsNotInstalledIsToldApart) {
  EXPECT_THAT(Explain({.output = "Failed to start cell.target: Unit "
                                 "cell.target not found.\n",
                       .exit_code = 5,
                       .is_user = true}),
              AllOf(HasSubstr("cmake --install"),
                    HasSubstr("systemctl --user daemon-reload")));
}

TEST(ServiceUnits, KeepWhatAServiceSaidAsItFailed) {
  const auto units = ParseUnits(
      "Id=cell-tracker.service\nActiveState=failed\nSubState=failed\n"
      "StatusText=tracker.yaml:period_ticks: missing (line 2)\n");
  ASSERT_EQ(units.size(), 1u);
  EXPECT_EQ(units[0].last_words, "tracker.yaml:period_ticks: missing (line 2)");
}

std::string ErrorOf(const std::string& text) {
  const std::filesystem::path source = CELL_SOURCE_DIR;
  const CellFiles files = FindCellFiles((source / "deploy").string());
  try {
    UnitEnvironment::Parse(text, "environment").Check(files);
  } catch (const ConfigError& e) {
    return e.what();
  }
  return "";
}

TEST(UnitEnvironment, NamesFileKeyAndLineOfWhatIsWrong) {
  EXPECT_EQ(ErrorOf("# a cell\nCELL_DEMONSTRATION=assembly\nCELL_SEED=\"7\"\n"
                    "OTHER=1\n"),
            "");
  EXPECT_THAT(
      ErrorOf("\nCELL_DEMONSTRATION=asembly\n"),
      AllOf(HasSubstr("environment:CELL_DEMONSTRATION: "),
            HasSubstr("did you mean 'assembly'?"), HasSubstr("(line 2)")));
  EXPECT_THAT(ErrorOf("CELL_SEED=seven"),
              HasSubstr("environment:CELL_SEED: 'seven'"));
  EXPECT_THAT(ErrorOf("CELL_URL=udpm://10.0.0.1:7667"),
              HasSubstr("environment:CELL_URL: "));
  EXPECT_THAT(ErrorOf("CELL_CAMERAS=yes"),
              HasSubstr("should be --cameras or nothing"));
  EXPECT_THAT(ErrorOf("CELL_SED=7"), AllOf(HasSubstr("environment:CELL_SED: "),
                                           HasSubstr("CELL_SEED")));
  EXPECT_THAT(ErrorOf("cell up"), HasSubstr("is not of the form KEY=VALUE"));
}

}  // namespace
}  // namespace cell
