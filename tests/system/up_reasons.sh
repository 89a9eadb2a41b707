#!/usr/bin/env bash
# Under a manager (under_systemd.sh): the output of `cell up` for a cell that
# cannot start, in OUT/.
set -u
out=$1
cell=/usr/local/bin/cell
state=$XDG_CONFIG_HOME/cell
config=/usr/local/etc/cell/config/tracker.yaml
up() {
  "$cell" up --user >"$out/$1.txt" 2>&1
  echo "exit code $?" >>"$out/$1.txt"
}
printf 'CELL_DEMONSTRATION=asembly\n' >"$state/environment"
up environment
rm "$state/environment"
sed -i 's/^period_ticks: .*/period_ticks: 0/' "$config"
up configuration
ls "$state" >"$out/left.txt"
# A fault that only the service itself finds.
mkdir /run/broken
cp -r /usr/local/etc/cell/config /usr/local/share/cell/tasks /run/broken
sed -i 's/^period_ticks: .*/period_ticks: 12/' "$config"
tracker=/usr/local/libexec/cell/tracker
mv "$tracker" "$tracker.whole"
printf '#!/bin/sh\nexec %s.whole --live --deploy /run/broken\n' "$tracker" >"$tracker"
chmod +x "$tracker"
up service
systemctl --user show -p NRestarts --value cell-tracker.service >"$out/restarts.txt"
"$cell" down --user
