#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/system/shell.h"

namespace cell {

/// All processes of a cell over LCM in `dir`, lcm-logger among them: its log is
/// `stock`, the recorder's own/cell-0001.lcmlog.
inline ShellResult RunBesideLcmLogger(const std::filesystem::path& dir,
                                      const std::string& vtb_options) {
  std::ofstream(dir / "run") << R"(
ip link set lo up && ip route add 224.0.0.0/4 dev lo
mkdir own
# Nobody waits for it, and it loses what it has no time to read: it comes first.
nice -n -15 lcm-logger --lcm-url='udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304' -q stock &
logger=$!
until grep -q :1DF3 /proc/net/udp; do :; done
pids=
for name in $(sed -n '/option:/d; s/.*{name: \([^,]*\),.*/\1/p' \
              $DEPLOY/config/roster.yaml)
do
  case $name in
    vtb) continue ;;
    *@*) instance="--instance ${name#*@}" ;;
    *) instance= ;;
  esac
  $BIN/${name%@*} $instance --deploy $DEPLOY --run-dir own & pids="$pids $!"
done
$BIN/vtb --deploy $DEPLOY --run-dir own --demonstration two_pegs $OPTIONS
code=$?
wait $pids
# What it has heard is with the disk once it answers nothing more.
kill $logger; wait $logger
exit $code
)";
  return Shell("cd " + dir.string() +
               " && BIN=" CELL_BIN_DIR " DEPLOY=" CELL_SOURCE_DIR
               "/deploy OPTIONS='" +
               vtb_options + "' " + InPrivateNetwork() + "bash ./run");
}

}  // namespace cell
