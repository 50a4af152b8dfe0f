#!/bin/sh
# Installs with apt what is missing of the tools in the arguments, and says so first. Each is probe:package, where the probe is a command
# or an absolute path. With everything present it does nothing and touches no network; without apt, root or sudo it says what to install.
set -eu

fail() {
    echo "surfpath: $1" >&2
    exit 1
}

present() {
    case $1 in
    /*) [ -e "$1" ] ;;
    *) command -v "$1" >/dev/null ;;
    esac
}

run_apt() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 "$@" </dev/null >>"$log" 2>&1
}

# Debian's emscripten brings Debian's nodejs, which would overwrite a newer Node that was copied to /usr/bin by hand.
keep_own_node() {
    if [ ! -e /usr/bin/node ] || dpkg -S /usr/bin/node >/dev/null 2>&1; then return; fi
    echo "keeping /usr/bin/node $(/usr/bin/node --version); Debian's goes to /usr/bin/node.debian"
    $as_root dpkg-divert --local --no-rename --divert /usr/bin/node.debian --add /usr/bin/node >>"$log"
}

node -e 'process.exit(parseInt(process.versions.node) < 20 ? 1 : 0)' 2>/dev/null || fail 'Node 20 or newer with npm is needed: install it, then run make again'

missing=
for tool in "$@"; do
    present "${tool%%:*}" || missing="$missing ${tool#*:}"
done
[ -n "$missing" ] || exit 0

command -v apt-get >/dev/null || fail "there is no apt-get here: install by hand what Debian calls$missing, then run make again"
as_root=
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "neither root nor sudo: have root run 'apt-get install$missing', then run make again"
    as_root=sudo
fi

echo "installing with apt:$missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
keep_own_node
# A third-party list that cannot be read need not matter: the installation decides.
run_apt update || true
# shellcheck disable=SC2086 # a list of words
run_apt install -y --no-install-recommends $missing || {
    tail -20 "$log" >&2
    fail "apt-get could not install$missing"
}
