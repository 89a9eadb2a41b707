#!/usr/bin/env bash
# Under a manager (under_systemd.sh): how fast the live cell is there, and back
# after a death, and what it loses with three camera sets in SECONDS. Logs go to
# SCRATCH: live_bench.sh SCRATCH SECONDS
set -euo pipefail
scratch=$1 seconds=$2
cell=/usr/local/bin/cell
state=$XDG_CONFIG_HOME/cell  # $STATE_DIRECTORY of a user's manager
mount --bind "$scratch" "$state"
printf 'CELL_DEMONSTRATION=assembly\nCELL_SEED=500\nCELL_CAMERAS=--cameras\n' \
  >"$state/environment"
systemctl --user add-wants cell.target cell-cameras.target 2>/dev/null

begin=0
start() { begin=$(date +%s%N); }
ms() { echo $((($(date +%s%N) - begin) / 1000000)); }
pid_of() { systemctl --user show -p MainPID --value "$1"; }
# Kills a unit five times and prints how long each took to be ready again. The
# manager's own stamps: who polls it takes the time from the cell.
kill_and_time() {
  local before died ready stamp times=()
  for _ in 1 2 3 4 5; do
    before=$(pid_of "$1")
    [[ $before -gt 1 ]] || { echo "$1 does not run" >&2; return 1; }
    died=$(date +%s%N)
    kill -KILL "$before"
    sleep 1.5
    stamp=$(systemctl --user show --timestamp=us+utc -p ActiveEnterTimestamp \
      --value "$1")
    ready=$(date -d "$stamp" +%s%N)
    ((ready > died)) || { echo "$1 is not back after 1.5 s" >&2; return 1; }
    times+=($(((ready - died) / 1000000)))
  done
  printf '%s\n' "${times[@]}" | sort -n | paste -sd ' '
}
# NAME VALUE UNIT [BASELINE BASELINE_VALUE]: a line for scripts/bench.
figure() {
  local line="{\"figure\": \"$1\", \"value\": $2, \"unit\": \"$3\", \"better\": \"less\""
  [[ $# -lt 5 ]] || line+=", \"baseline\": \"$4\", \"baseline_value\": $5"
  echo "$line}"
}
median() { cut -d ' ' -f 3 <<<"$1"; }

start
systemd-run --user --quiet --wait true
nothing=$(ms)
systemd-run --user --quiet --unit=nothing -p Restart=always -p RestartSec=0 \
  -p StartLimitIntervalSec=0 sleep infinity
restart=$(median "$(kill_and_time nothing.service)")
systemctl --user stop nothing.service

start
"$cell" up --user >/dev/null
figure "live cell with cameras, from cell up to ready" "$(ms)" ms \
  "a unit that does nothing" "$nothing"
sleep 2
for service in vtb tracker sec-builder recognizer predicate-estimator planner \
  supervisor robot-arm@left robot-arm@right library recorder camera-set@1; do
  times=$(kill_and_time "cell-$service.service")
  echo "$service: $times ms" >&2
  figure "$service, from kill -9 to ready" "$(median "$times")" ms \
    "a unit that sleeps" "$restart"
done
"$cell" down --user >/dev/null

# One assembly after the other.
"$cell" up --user >/dev/null
for ((left = seconds; left > 0; left -= 100)); do
  sleep $((left < 100 ? left : 100))
  "$cell" episode start --demonstration assembly \
    --seed "$left" >/dev/null
done
"$cell" top --reports 1 --period 5 >&2
"$cell" down --user >/dev/null
run=$(readlink -f "$state/runs/current")
bytes=$(du -bc "$run"/*.lcmlog | tail -n 1 | cut -f 1)
figure "live cell's log" $((bytes * 60 / seconds / 1000000)) MB/min
is_incomplete=0
"$cell" log check "$run" >&2 || is_incomplete=1
figure "live cell's logs that are incomplete" $is_incomplete logs
