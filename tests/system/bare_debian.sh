#!/usr/bin/env bash
# Installs a bare Debian 12 in the new folder ROOT and does there what the README
# lists, from top to bottom: first its commands, beginning with scripts/demo on
# this commit, then, booted without a network, those of a cell that stays. Prints
# each line, what came of it and how long it took; docs/bare_debian.txt is such a
# transcript. scripts/test is left out. As root, with debootstrap and
# systemd-container:
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

# The README's lines of a user's own run, and of a cell that stays.
lines() { sed -n "/^## $1/,/^## $2/s/^    //p" "$source/README.md"; }
lines 'Two commands' 'Repository layout' | grep -E '^(scripts/demo|build/)' \
  >"$root/root/first_lines"
lines 'A cell that stays' 'How the arms work' >"$root/root/lines"

# Runs the lines of a file; a long answer is cut in the middle.
cat >"$root/root/run_lines" <<'EOF'
cd /root/cell
seen() { cell replay /var/lib/cell/runs/current 2>/dev/null; }
while IFS= read -r line; do
  if [[ $line == *replay*current* ]]; then  # not before the person has shown it all
    for _ in $(seq 180); do
      seen | grep -q 'the episode ends' && break
      sleep 1
    done
  fi
  echo "\$ $line"
  began=$SECONDS
  code=0
  bash -c "$line" </dev/null >/root/answer 2>&1 || code=$?
  tr '\r' '\n' </root/answer | grep -v '^Get:' | cut -c1-160 | awk -v most=60 '
    { line[NR] = $0 }
    END {
      for (i = 1; i <= NR; ++i) {
        if (NR <= most || i <= most / 2 || i > NR - most / 2) print line[i]
        else if (i == most / 2 + 1) print "[... " NR - most " more lines]"
      }
    }'
  [[ $code == 0 ]] || echo "[exit code $code]"
  echo "[after $((SECONDS - began)) s]"
  echo
done
EOF
inside --chdir=/root/cell bash -c 'bash /root/run_lines </root/first_lines' \
  </dev/null

cat >"$root/root/run_installed" <<'EOF'
bash /root/run_lines </root/lines
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
ExecStart=/bin/bash /root/run_installed
StandardOutput=file:/root/said
[Install]
WantedBy=default.target
EOF
inside systemctl -q enable lines.service
inside --private-network --boot >&2 </dev/null
cat "$root/root/said"
