# SPDX-License-Identifier: GPL-3.0-or-later
# prepare.sh - for experiments/run and tests/run: installs missing Debian packages, configures and
# builds. To be sourced.

say() { printf '== %s\n' "$*"; }

# What building and running need; tests/run asks for more.
build_packages=(
    build-essential cmake pkg-config git
    libbox2d-dev libgsl-dev libhdf5-dev librandom123-dev libyaml-dev libmuparser-dev libcairo2-dev
    libcmocka-dev fonts-dejavu-core
)

# Installs those of the given packages that are not there; asks nothing of the network if all are.
install_packages() {
    local missing=() package
    for package in "$@"; do
        dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed ||
            missing+=("$package")
    done
    if [ ${#missing[@]} -eq 0 ]; then
        say "all packages are installed"
        return
    fi
    say "installing ${missing[*]}"
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        as_root=(sudo)
        command -v sudo >/dev/null || {
            echo "please install as root: apt-get install ${missing[*]}" >&2
            exit 4
        }
    fi
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# build_in FOLDER [CMAKE OPTION...]
build_in() {
    local folder=$1
    shift
    say "building in $folder"
    cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Release "$@" >"$folder.log" 2>&1 &&
        cmake --build "$folder" -j "$(nproc)" >>"$folder.log" 2>&1 || {
        cat "$folder.log" >&2
        echo "the build failed" >&2
        exit 4
    }
}
