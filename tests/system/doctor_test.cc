// cell doctor on machines that each have one fault: finds it and nothing else;
// what it says helps.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/system/run_cell.h"

namespace cell {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

// A well kept machine: its system files below root/, the cell beside it. The
// network is real, but private.
class Doctor : public RunCell {
 protected:
  void SetUp() override {
    RunCell::SetUp();
    const fs::path root = dir_ / "root";
    Write(root / "proc/sys/net/core/rmem_max", "8388608\n");
    Write(root / "proc/sys/kernel/unprivileged_userns_clone", "1\n");
    Write(root / "etc/sysctl.d/60-cell.conf", "net.core.rmem_max = 8388608\n");
    Write(root / "lib/systemd/system/systemd-timesyncd.service",
          "[Service]\nExecStart=/bin/true\n"
          "[Install]\nWantedBy=sysinit.target\n");
    Write(root / "sys/devices/system/cpu/cpu0/cpufreq/scaling_governor",
          "performance\n");
    Write(root / "usr/lib/jvm/java/bin/java", "");
    Write(root / "usr/lib/jvm/java/lib/libawt_xawt.so", "");
    Write(root / "usr/share/java/lcm.jar", "");
    Write(root / "usr/share/java/jchart2d.jar", "");
    WritePackages(root / "var/lib/dpkg/status");
    const fs::path wants = root / "etc/systemd/system/sysinit.target.wants";
    fs::create_directories(wants);
    fs::create_symlink("/lib/systemd/system/systemd-timesyncd.service",
                       wants / "systemd-timesyncd.service");
    fs::create_directory_symlink("/proc/net", root / "proc/net");

    const fs::path source = CELL_SOURCE_DIR;
    for (const char* folder : {"deploy", "lcmtypes"}) {
      fs::copy(source / folder, dir_ / folder, fs::copy_options::recursive);
    }
    Write(dir_ / "deploy/spy/cell_types.jar", "");
    fs::create_directories(dir_ / "bin");
    for (const auto& entry : fs::directory_iterator(CELL_BIN_DIR)) {
      fs::create_symlink(entry.path(), dir_ / "bin" / entry.path().filename());
    }
    fs::remove(dir_ / "bin/tracker");
    fs::copy(fs::path(CELL_BIN_DIR) / "tracker", dir_ / "bin/tracker");
    Write(dir_ / "runs/sim-0001/run.yaml", "");
    Write(dir_ / "runs/sim-0001/cell-0001.lcmlog", "");
  }

  static void Write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }

  static void WritePackages(const fs::path& path) {
    std::ifstream list(CELL_SOURCE_DIR "/scripts/packages.txt");
    std::string status;
    for (std::string line; std::getline(list, line);) {
      if (line.starts_with("#") || line.empty()) continue;
      status += "Package: " + line + "\nStatus: install ok installed\n\n";
    }
    Write(path, status);
  }

  // What doctor complains of, line by line: before `fault`, with it, and after
  // what is said to fix it; all in one shell.
  struct Visit {
    std::vector<std::string> before, with_fault, after;
    std::string exit_codes;
    std::string output;
  };
  Visit Examine(const std::string& fault, bool is_fixed = true) {
    const std::string doctor =
        kCell +
        " doctor --root $PWD/root --deploy deploy --programs $PWD/bin "
        "--runs runs --min-free-mb 8";
    Write(dir_ / "visit",
          "ip link set lo up && ip route add 224.0.0.0/4 dev lo\n"
          "unset LCM_DEFAULT_URL\n" +
              doctor + " > before; echo -n $? > codes\n" + fault + "\n" +
              doctor + " > with_fault; echo -n $? >> codes\n" +
              "fix=$(sed -nE '/^(BAD|warn)/s/.*; fix: //p' with_fault)\n" +
              (is_fixed ? "eval \"$fix\"\nwait\n" : "") + doctor +
              " > after; echo -n $? >> codes\n");
    Visit visit;
    visit.output = Shell("cd " + dir_.string() + " && " + InPrivateNetwork() +
                         WithPrivateMounts() + "bash -e -c 'set +e; . ./visit'")
                       .output;
    visit.before = Complaints("before");
    visit.with_fault = Complaints("with_fault");
    visit.after = Complaints("after");
    visit.exit_codes = TextOf(dir_ / "codes");
    return visit;
  }

  std::vector<std::string> Complaints(const std::string& file) const {
    std::istringstream lines(TextOf(dir_ / file));
    std::vector<std::string> complaints;
    size_t num = 0;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("ok ")) complaints.push_back(line);
      ++num;
    }
    EXPECT_GE(num, 13u) << file;
    if (!complaints.empty()) complaints.pop_back();  // the sum
    return complaints;
  }
};

struct Fault {
  const char* name;
  const char* line;   // that doctor says, its beginning
  const char* plant;  // shell command
};

class DoctorFinds : public Doctor, public testing::WithParamInterface<Fault> {};

TEST_P(DoctorFinds, OneFaultAloneAndWhatItSaysHelps) {
  const Visit visit = Examine(GetParam().plant);
  EXPECT_THAT(visit.before, IsEmpty()) << visit.output;
  EXPECT_THAT(visit.with_fault, ElementsAre(AllOf(StartsWith(GetParam().line),
                                                  HasSubstr("; fix: "))))
      << visit.output;
  EXPECT_THAT(visit.after, IsEmpty()) << visit.output;
  EXPECT_EQ(visit.exit_codes,
            std::string(GetParam().line).starts_with("BAD") ? "010" : "000");
}

INSTANTIATE_TEST_SUITE_P(
    Faults, DoctorFinds,
    testing::Values(
        Fault{"LoopbackDown", "BAD  loopback: ", "ip link set lo down"},
        Fault{"NoMulticastRoute",
              "BAD  multicast route: ", "ip route del 224.0.0.0/4"},
        Fault{"Ttl", "BAD  ttl: ",
              "export LCM_DEFAULT_URL='udpm://239.255.76.67:7667?ttl=1'"},
        Fault{"StrangerOnTheControlPort", "BAD  control port: ",
              "lcm-logger --lcm-url='udpm://239.255.76.67:7668?ttl=0' l "
              "> /dev/null 2>&1 &\n"
              "until grep -q :1DF4 /proc/net/udp; do :; done\n"
              "ln -s /proc/$! root/proc/$!"},
        Fault{"SmallBuffer", "BAD  receive buffer: ",
              "echo 212992 > root/proc/sys/net/core/rmem_max"},
        Fault{"SmallBufferAtBoot",
              "warn receive buffer at boot: ", "rm -r root/etc/sysctl.d"},
        Fault{"NoTimeService", "warn time service: ",
              "rm root/etc/systemd/system/sysinit.target.wants/*"},
        Fault{"SlowProcessors", "warn processors: ",
              "echo powersave > "
              "root/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"},
        Fault{"NoPrivateNetworks", "BAD  private networks: ",
              "echo 0 > root/proc/sys/kernel/unprivileged_userns_clone"},
        Fault{"LockedRuns", "BAD  runs folder: ", "chmod 0500 runs"},
        Fault{"FullDisk", "BAD  disk: ",
              "mount -t tmpfs -o size=16m tmpfs runs\n"
              "mkdir runs/old && touch runs/old/run.yaml\n"
              "head -c 12000000 /dev/zero > runs/old/cell-0001.lcmlog"},
        Fault{"ClockJumpedBack",
              "BAD  clock: ", "touch -d '+1 day' runs/sim-0001"},
        Fault{"StaleRun", "warn stale runs: ",
              "mkdir runs/sim-0002 && touch runs/sim-0002/run.yaml && "
              "touch -d '1 hour ago' runs/sim-0002"},
        Fault{"LockedProgram", "BAD  programs: ", "chmod -x bin/tracker"},
        Fault{"DriftedTypes", "BAD  message types: ",
              "echo '// a unit' >> lcmtypes/tracks_t.lcm"},
        Fault{"NoTypes",
              "BAD  message types: there are no message type texts in ",
              "rm -r lcmtypes"}),
    [](const auto& test_info) { return test_info.param.name; });

TEST_F(Doctor, NamesTheKeyThatIsWrongAndNeverACommandThatOverwritesTheFile) {
  for (const std::string file : {"roster", "tracker"}) {
    const std::string path = "deploy/config/" + file + ".yaml";
    const Visit visit = Examine("echo 'typo: 1' >> " + path, false);
    const std::string line =
        file == "roster" ? "BAD  roster: " : "BAD  configuration: ";
    EXPECT_THAT(
        visit.with_fault,
        ElementsAre(AllOf(
            StartsWith(line),
            HasSubstr(path + ":typo: not known; remove it or correct its "),
            HasSubstr("(line "), HasSubstr("; fix: correct it there; diff "),
            Not(HasSubstr("; fix: cp ")), Not(HasSubstr("checkout")))))
        << visit.output;
    fs::copy_file(fs::path(CELL_SOURCE_DIR) / path, dir_ / path,
                  fs::copy_options::overwrite_existing);
  }
}

TEST_F(Doctor, CountsTheTypesItDoesNotName) {
  const Visit visit =
      Examine("for t in lcmtypes/*; do echo >> $t; done", false);
  ASSERT_EQ(visit.with_fault.size(), 1u) << visit.output;
  EXPECT_THAT(visit.with_fault.front(),
              AllOf(HasSubstr("different: ack_t.lcm, "), HasSubstr(" more. ")));
  EXPECT_LT(visit.with_fault.front().size(), 600u);
}

TEST_F(Doctor, NamesPackagesAndJarsThatAreMissing) {
  const Visit visit = Examine(
      "sed -i '/Package: iproute2/,+2d; /Package: xvfb/,+2d' "
      "root/var/lib/dpkg/status; rm root/usr/share/java/lcm.jar",
      false);
  EXPECT_THAT(
      visit.with_fault,
      ElementsAre(
          AllOf(StartsWith("BAD  packages: missing for operating"),
                testing::EndsWith("--no-install-recommends iproute2")),
          AllOf(StartsWith("warn lcm-spy: "), HasSubstr("lcm.jar is missing"),
                testing::EndsWith("liblcm-java"))))
      << visit.output;
  EXPECT_EQ(visit.exit_codes, "011");
}

TEST_F(Doctor, NamesTheTypesInWhichARunDiffersFromTheBuild) {
  fs::copy(dir_ / "lcmtypes", dir_ / "runs/sim-0001/lcmtypes");
  const std::string command =
      "doctor --programs bin --deploy deploy --run runs/sim-0001 | grep '"
      "types of the run'";
  EXPECT_THAT(Cell(command).output, StartsWith("ok "));
  std::ofstream(dir_ / "runs/sim-0001/lcmtypes/tracks_t.lcm") << "// older";
  EXPECT_THAT(Cell(command).output,
              AllOf(StartsWith("BAD "), HasSubstr("tracks_t.lcm")));
}

}  // namespace
}  // namespace cell
