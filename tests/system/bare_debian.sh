#!/usr/bin/env bash
# Installs a bare Debian 12 in the new folder ROOT, builds this commit there, boots
# it without a network and runs what the README says of a cell that stays. Says
# each line and what came of it; docs/bare_debian.txt is what it once said. As
# root, with debootstrap and systemd-container:
#   tests/system/bare_debian.sh ROOT >docs/bare_debian.txt
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
root=$(realpath -m "$1")
[[ ! -e $root ]] || { echo "$root: is there already; name a new folder" >&2; exit 2; }

debootstrap --variant=minbase \
  --include=ca-certificates,dbus,git,sudo,systemd-sysv \
  bookworm "$root" "${MIRROR:-http://deb.debian.org/debian}" >&2
git clone -q "$source" "$root/root/cell"
inside() { systemd-nspawn -q --register=no --keep-unit -D "$root" "$@"; }
echo bare >"$root/etc/hostname"
echo '127.0.1.1 bare' >>"$root/etc/hosts"  # sudo asks who it is
inside --chdir=/root/cell sh -c 'scripts/setup && scripts/build release' >&2

# The lines below the README's heading, run by the booted system.
sed -n '/^## A cell that stays/,/^## [^A]/s/^    //p' "$source/README.md" \
  >"$root/root/lines"
cat >"$root/root/run_lines" <<'EOF'
cd /root/cell
seen() { cell replay /var/lib/cell/runs/current 2>/dev/null; }
while IFS= read -r line; do
  if [[ $line == *replay* ]]; then  # not before the person has shown it all
    for _ in $(seq 180); do
      seen | grep -q 'the episode ends' && break
      sleep 1
    done
  fi
  echo "\$ $line"
  bash -c "$line" </dev/null 2>&1 || echo "[exit code $?]"
done </root/lines
echo "left below /usr/local:"
find /usr/local -type f
echo "left of its state:"
(cd /var/lib/cell && find . -maxdepth 3 | sort)
EOF
cat >"$root/etc/systemd/system/lines.service" <<'EOF'
[Unit]
After=multi-user.target
SuccessAction=poweroff
FailureAction=poweroff
[Service]
Type=oneshot
Environment=SYSTEMD_COLORS=0
ExecStart=/bin/bash /root/run_lines
StandardOutput=file:/root/said
[Install]
WantedBy=default.target
EOF
inside systemctl -q enable lines.service
inside --private-network --boot >&2 </dev/null
cat "$root/root/said"
