# Set-up shared by ./fringe, ./test, .ci/run and the scripts under tests/; bash, to be sourced.
# Installs the Debian packages that are missing and brings build/release up to date. It prints to standard error
# only, so that standard output belongs to the program, and exits with status 2 where the machine cannot do it.
# When nothing is to do it costs a few milliseconds.
# shellcheck shell=bash

fringeRoot=$(readlink -f "${BASH_SOURCE[0]}")
fringeRoot=${fringeRoot%/third_party/setup.sh}
packageList=$fringeRoot/third_party/debian-packages.txt
releaseFolder=$fringeRoot/build/release

# say MESSAGE [LINE...]: further lines, such as a command to copy, are indented.
say() {
    printf '%s: %s\n' "${0##*/}" "$1" >&2
    (($# == 1)) || printf '    %s\n' "${@:2}" >&2
}

fail() {
    say "$@"
    exit 2
}

# listPackages GROUP...: the lines of the package list that belong to any of the groups.
listPackages() {
    local line name groups group
    while read -r line; do
        read -r name groups _ <<<"$line"
        [[ -z $name || $name == '#'* ]] && continue
        for group in "$@"; do
            if [[ ,$groups, == *,$group,* ]]; then
                printf '%s\n' "$line"
                break
            fi
        done
    done <"$packageList"
}

# missingPackages GROUP...: the names of the packages of the groups that dpkg does not know as installed.
missingPackages() {
    local names installed name
    mapfile -t names < <(listPackages "$@" | cut --delimiter=' ' --fields=1)
    installed=$(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "${names[@]}" 2>/dev/null || true)
    for name in "${names[@]}"; do
        [[ $'\n'$installed$'\n' == *$'\n'"$name installed"$'\n'* ]] || printf '%s\n' "$name"
    done
}

# True when the Vulkan loader would find a driver of any make, so that Mesa's need not be installed.
hasVulkanDriver() {
    [[ -n ${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-} ]] && return
    compgen -G '/usr/share/vulkan/icd.d/*.json' >/dev/null || compgen -G '/etc/vulkan/icd.d/*.json' >/dev/null ||
        compgen -G '/usr/local/share/vulkan/icd.d/*.json' >/dev/null
}

explainOtherDistribution() {
    say "this system has no dpkg and apt-get, so installing the packages is up to you"
    printf '\nWhat is needed, under its name in Debian 12:\n\n' >&2
    listPackages "$@" >&2
    cat >&2 <<END

Then, once, in $fringeRoot:

    cmake --preset release              (-DFRINGE_TESTS=OFF leaves the tests out)
    cmake --build --preset release

From then on ${0##*/} works as it does on Debian; the program is build/release/fringe.
END
    exit 2
}

installPackages() {
    local asRoot=() command=(apt-get install --yes --no-install-recommends "$@")
    ((EUID == 0)) || asRoot=(sudo)
    if [[ ${FRINGE_NO_INSTALL:-0} != 0 ]] || { ((EUID != 0)) && ! command -v sudo >/dev/null; }; then
        fail "these Debian packages are missing: $*" "as root run: apt-get update && ${command[*]}"
    fi
    say "installing the Debian packages that are missing: $*"
    # Always fresh lists: an installation happens once per machine, and stale lists name packages that are gone.
    # A failed update (one bad source among many) may still leave what is needed.
    "${asRoot[@]}" apt-get -o DPkg::Lock::Timeout=300 update >&2 || say "apt-get update failed; trying to go on"
    "${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive "${command[@]}" -o DPkg::Lock::Timeout=300 >&2 ||
        fail "apt-get could not install the packages: its messages are above. Is the network up? By hand, as root:" \
            "apt-get update && ${command[*]}"
}

# needPackages GROUP...: installs what is missing of the groups, or where it may not or cannot, says so and exits.
# A stamp younger than the list and than dpkg's own records means that they were found complete.
needPackages() {
    local stamp missing
    stamp=$fringeRoot/build/packages-$(IFS=-; printf '%s' "$*")
    [[ $stamp -nt $packageList && $stamp -nt /var/lib/dpkg/status ]] && return
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        [[ -e $releaseFolder/build.ninja ]] || explainOtherDistribution "$@"
        return 0
    fi

    mapfile -t missing < <(missingPackages "$@")
    ((${#missing[@]} == 0)) || installPackages "${missing[@]}"
    # A read-only checkout has no stamp and asks dpkg each time.
    [[ ! -w $fringeRoot ]] || { mkdir -p "${stamp%/*}" && : >"$stamp"; }
}

# isConfigured TESTS: whether build/release is a complete configuration of this very checkout (a copied or moved one
# still names its old place), and has the tests if TESTS is ON.
isConfigured() {
    local cache=$releaseFolder/CMakeCache.txt
    [[ -e $releaseFolder/build.ninja ]] &&
        grep --quiet --line-regexp --fixed-strings "CMAKE_HOME_DIRECTORY:INTERNAL=$fringeRoot" "$cache" &&
        { [[ $1 == OFF ]] || grep --quiet '^FRINGE_TESTS:BOOL=ON' "$cache"; }
}

# Looks again for the packages of the preview's window where the configuration is from before they were installed.
findPreview() {
    if isConfigured OFF && ! grep --quiet '^FRINGE_PREVIEW:INTERNAL=ON' "$releaseFolder/CMakeCache.txt"; then
        cmake --log-level=NOTICE "$releaseFolder" >&2 || fail "could not configure the build; the message above says why"
    fi
}

isUpToDate() {
    local target=$1 tests=$2
    isConfigured "$tests" && [[ $(ninja -C "$releaseFolder" -n "$target") == *'ninja: no work to do.'* ]]
}

configureRelease() {
    local tests=$1 fresh=()
    isConfigured OFF || fresh=(--fresh)
    say "configuring $releaseFolder"
    # The preset is found from the source folder.
    (cd "$fringeRoot" && cmake --log-level=NOTICE "${fresh[@]}" --preset release -DFRINGE_TESTS="$tests") >&2 ||
        fail "could not configure the build; the message above says why"
}

# buildRelease TARGET TESTS: brings TARGET in build/release up to date. With TESTS=OFF a new configuration leaves the
# tests out, so that the program needs the fewest packages; one that has them keeps them. Both share their objects.
buildRelease() {
    local target=$1 tests=$2
    [[ -d $releaseFolder ]] || mkdir -p "$releaseFolder" ||
        fail "cannot write to $fringeRoot; copy it to where you can, or build elsewhere:" \
            "cmake -S '$fringeRoot' -B FOLDER -G Ninja && cmake --build FOLDER"

    # One builder at a time. The lock is on the folder itself and ends before the program runs.
    exec 9<"$releaseFolder"
    flock --nonblock 9 || { say "waiting for another build in $releaseFolder"; flock 9; }
    if ! isUpToDate "$target" "$tests"; then
        [[ -w $releaseFolder ]] || fail "$releaseFolder is out of date and cannot be written to"
        trap 'exit 130' INT  # ninja reports an interruption as an ordinary failure
        isConfigured "$tests" || configureRelease "$tests"
        say "building in $releaseFolder"
        ninja -C "$releaseFolder" "$target" >&2 || fail "could not build; the message above says why"
        trap - INT
    fi
    exec 9<&-
}
