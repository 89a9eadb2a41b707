#include <gmock/gmock.h>

#include <map>
#include <set>

#include "services/cell/doctor/packages.h"
#include "services/cell/doctor/proc_table.h"
#include "services/cell/doctor/spy_command.h"

namespace cell {

using namespace cli;
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Files and links by path; folders are what lies above them.
class PaperMachine : public Machine {
 public:
  std::map<std::string, std::string> files;
  std::map<std::string, std::string> links;

  std::optional<std::string> Read(const std::string& path) const override {
    const auto it = files.find(path);
    if (it == files.end()) return std::nullopt;
    return it->second;
  }
  std::vector<std::string> List(const std::string& path) const override {
    std::set<std::string> names;
    for (const auto* all : {&files, &links}) {
      for (const auto& [name, text] : *all) {
        if (!name.starts_with(path + "/")) continue;
        const std::string rest = name.substr(path.size() + 1);
        names.insert(rest.substr(0, rest.find('/')));
      }
    }
    return {names.begin(), names.end()};
  }
  std::optional<Status> StatusOf(const std::string& path) const override {
    if (!files.contains(path)) return std::nullopt;
    return Status{};
  }
  std::optional<std::string> LinkAt(const std::string& path) const override {
    const auto it = links.find(path);
    if (it == links.end()) return std::nullopt;
    return it->second;
  }
  std::optional<int64_t> FreeBytes(const std::string&) const override {
    return std::nullopt;
  }
  std::optional<std::string> Environment(const std::string&) const override {
    return std::nullopt;
  }
  int64_t NowSeconds() const override { return 0; }
};

constexpr char kHead[] =
    "Iface Destination Gateway Flags RefCnt Use Metric Mask MTU Window IRTT\n";
constexpr char kDefault[] =
    "eth0 00000000 010200C0 0003 0 0 0 00000000 0 0 0\n";

TEST(RouteTo, TakesTheNarrowestThenTheCheapest) {
  const std::string group = "239.255.76.67";
  EXPECT_EQ(RouteTo(group, kHead), std::nullopt);
  EXPECT_EQ(RouteTo(group, std::string(kHead) + kDefault), "eth0");
  const std::string with_lo =
      std::string(kHead) + kDefault +
      "lo 000000E0 00000000 0001 0 0 5 000000F0 0 0 0\n";
  EXPECT_EQ(RouteTo(group, with_lo), "lo");
  EXPECT_EQ(RouteTo("192.0.2.7", with_lo), "eth0");
  EXPECT_EQ(
      RouteTo(group,
              with_lo + "eth1 000000E0 00000000 0001 0 0 2 000000F0 0 0 0\n"),
      "eth1");
}

TEST(RouteTo, IsNotConfusedByAnythingElse) {
  EXPECT_EQ(RouteTo("239.255.76", kDefault), std::nullopt);
  EXPECT_EQ(RouteTo("239.255.76.67", "eth0 zzz 0 0 0 0 0 zzz\nshort\n"),
            std::nullopt);
}

TEST(ReceivesMulticast, IsTrueOfTheDevicesThatAreUp) {
  const std::string table =
      "Idx Device    : Count Querier Group    Users Timer Reporter\n"
      "1\tlo        :     1      V3\n\t\t010000E0     1 0:00000000\t0\n";
  EXPECT_TRUE(ReceivesMulticast("lo", table));
  EXPECT_FALSE(ReceivesMulticast("eth0", table));
  EXPECT_FALSE(ReceivesMulticast("lo", "Idx Device    : Count Querier\n"));
}

TEST(OwnersOfUdpPort, AreThoseThatHoldTheSocket) {
  PaperMachine machine;
  machine.files["/r/proc/net/udp"] =
      "  sl  local_address rem_address st tx rx tr tm->when retrnsmt uid "
      "timeout inode\n"
      " 1: 00000000:1DF4 00000000:0000 07 0:0 00:0 0 0 0 4242 2 0 0\n"
      " 2: 00000000:1DF3 00000000:0000 07 0:0 00:0 0 0 0 4243 2 0 0\n";
  machine.files["/r/proc/77/comm"] = "vtb\n";
  machine.links["/r/proc/77/fd/3"] = "socket:[4242]";
  machine.files["/r/proc/78/comm"] = "tracker\n";
  machine.links["/r/proc/78/fd/3"] = "socket:[4243]";
  const auto owners = OwnersOfUdpPort(machine, "/r", 7668);
  ASSERT_EQ(owners.size(), 1u);
  EXPECT_EQ(owners[0].pid, 77);
  EXPECT_EQ(owners[0].name, "vtb");
  EXPECT_THAT(OwnersOfUdpPort(machine, "/r", 7000), IsEmpty());
}

TEST(MissingPackages, AreSplitByWhatTheyAreFor) {
  const MissingPackages missing = FindMissingPackages(
      "# Build\ncmake\nninja-build\n# Operating and looking\niproute2\n"
      "procps\n# Checks\ngit\n",
      "Package: cmake\nStatus: install ok installed\n\n"
      "Package: git\nStatus: deinstall ok config-files\n\n"
      "Package: procps\nStatus: install ok installed\n");
  EXPECT_THAT(missing.operating, ElementsAre("iproute2"));
  EXPECT_THAT(missing.others, ElementsAre("ninja-build", "git"));
}

TEST(SpyParts, AHeadlessJavaWillNotDo) {
  PaperMachine machine;
  machine.files["/usr/lib/jvm/java-17/bin/java"] = "";
  machine.files["/usr/share/java/lcm.jar"] = "";
  machine.files["/usr/share/java/jchart2d.jar"] = "";
  machine.files["/opt/cell/deploy/spy/cell_types.jar"] = "";
  SpyParts parts = FindSpyParts(machine, "", "/opt/cell/build/bin");
  ASSERT_EQ(parts.missing.size(), 1u);
  EXPECT_THAT(parts.missing[0].what, HasSubstr("headless"));
  machine.files["/usr/lib/jvm/java-17/lib/libawt_xawt.so"] = "";
  parts = FindSpyParts(machine, "", "/opt/cell/build/bin");
  EXPECT_THAT(parts.missing, IsEmpty());
  EXPECT_THAT(
      SpyCommand(parts, "udpm://239.255.76.67:7667?ttl=0"),
      ElementsAre("/usr/lib/jvm/java-17/bin/java",
                  "-Djava.net.preferIPv4Stack=true", "-cp",
                  "/usr/share/java/lcm.jar:/usr/share/java/jchart2d.jar:"
                  "/opt/cell/deploy/spy/cell_types.jar",
                  "lcm.spy.Spy", "--lcm-url=udpm://239.255.76.67:7667?ttl=0"));
}

}  // namespace
}  // namespace cell
