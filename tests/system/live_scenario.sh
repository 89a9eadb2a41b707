#!/usr/bin/env bash
# Under a manager (under_systemd.sh): a person assembles, live, while every
# service but the testbed is killed once and hangs once. Its output goes to
# OUT/.
set -u
out=$1
cell=/usr/local/bin/cell
state=$XDG_CONFIG_HOME/cell  # $STATE_DIRECTORY of a user's manager
printf 'CELL_DEMONSTRATION=assembly\nCELL_SEED=7\n' >"$state/environment"
"$cell" up --user >"$out/up.txt" || { cat "$out/up.txt" /run/manager.log; exit 1; }
# A second recording: the recorder's own log lacks the messages that come while
# it hangs.
"$cell" record --deploy "$state/runs/current/deploy" --out "$out/glimpse" \
  >"$out/glimpse.txt" 2>&1 &
ears=$!
main_pid() { systemctl --user show -p MainPID --value "$1"; }
is_ready() { [[ $(systemctl --user show -p ActiveState --value "$1") == active ]]; }
for signal in KILL STOP; do
  for service in tracker sec-builder recognizer predicate-estimator planner \
    supervisor robot-arm@left robot-arm@right library motion-planner recorder; do
    unit=cell-$service.service
    before=$(main_pid "$unit")
    begin=$(date +%s%N)
    kill -"$signal" "$before"
    for _ in $(seq 6000); do
      now=$(main_pid "$unit")
      [[ $now != "$before" && $now != 0 ]] && is_ready "$unit" && break
      sleep 0.01
    done
    echo "$service $signal: ready after $((($(date +%s%N) - begin) / 1000000)) ms"
    sleep 1
  done
done >"$out/restarts.txt"
"$cell" status --user >"$out/status.txt"
echo "exit code $?" >>"$out/status.txt"
"$cell" top --reports 1 --period 10 >"$out/top.txt"
for _ in $(seq 600); do
  "$cell" replay "$state/runs/current" >"$out/told.txt" 2>/dev/null
  grep -q 'the episode ends' "$out/told.txt" && break
  sleep 1
done
sleep 20  # unrecognised changes are reported after the episode
kill -TERM "$ears"
wait "$ears"
"$cell" replay "$out/glimpse" >"$out/heard.txt" 2>&1
"$cell" down --user >"$out/down.txt"
"$cell" replay "$state/runs/current" >"$out/told.txt" 2>/dev/null
"$cell" replay "$state/runs/current" --check >"$out/check.txt" 2>&1
cmake --build "$2" --target uninstall >/dev/null
find /usr/local -type f >"$out/left.txt"
exit 0
