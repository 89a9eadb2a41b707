#!/usr/bin/env bash
# Installs a build in a mount, network and process namespace of its own, starts a
# systemd --user manager there and runs a command under it:
#   unshare -n -m -p -f under_systemd.sh BUILD COMMAND...
# Exit code 77: no manager can run here.
set -u
build=$1
shift
mount -t proc proc /proc && mount -t tmpfs tmpfs /run && mount -t tmpfs tmpfs /usr/local || exit 77
mountpoint -q /sys/fs/cgroup || mount -t cgroup2 cgroup2 /sys/fs/cgroup || exit 77
mkdir -p /run/systemd/system /run/user /run/home/.config/cell
ip link set lo up && ip route add 224.0.0.0/4 dev lo
cmake --install "$build" >/run/install.log 2>&1 || { cat /run/install.log; exit 1; }
export HOME=/run/home XDG_RUNTIME_DIR=/run/user XDG_CONFIG_HOME=/run/home/.config
export SYSTEMD_UNIT_PATH=$XDG_CONFIG_HOME/systemd/user:/usr/local/lib/systemd/user:/usr/lib/systemd/user
export SYSTEMD_GENERATOR_PATH=/nonexistent
unset DBUS_SESSION_BUS_ADDRESS
/lib/systemd/systemd --user --default-standard-output=inherit >/run/manager.log 2>&1 &
manager=$!
for _ in $(seq 100); do
  systemctl --user list-units >/dev/null 2>&1 && break
  kill -0 "$manager" 2>/dev/null || { cat /run/manager.log; exit 77; }
  sleep 0.1
done
"$@"
code=$?
systemctl --user exit
wait "$manager"
exit "$code"
