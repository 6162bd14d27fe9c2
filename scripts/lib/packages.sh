# SPDX-License-Identifier: BSD-3-Clause
# What has to be installed, by purpose, and how. Sourced after common.sh.

say() { printf '==> %s\n' "$*"; }
fail() { printf '%s: %s\n' "${0##*/}" "$*" >&2; exit 2; }

# Debian packages ROS 1 itself, in /usr.
HIDWA_DEBIAN_BUILD="build-essential cmake catkin python3-setuptools
  libroscpp-dev librosconsole-dev python3-rospy pluginlib-dev librosbag-dev
  ros-message-generation ros-message-runtime ros-cmake-modules python3-genmsg python3-gencpp python3-genpy python3-genlisp
  libgeometry-msgs-dev libnav-msgs-dev libsensor-msgs-dev libvisualization-msgs-dev libstd-srvs-dev libmap-msgs-dev
  libmove-base-msgs-dev ros-std-msgs ros-geometry-msgs ros-nav-msgs ros-sensor-msgs ros-map-msgs
  ros-visualization-msgs ros-actionlib-msgs ros-move-base-msgs ros-std-srvs
  libactionlib-dev libangles-dev libmessage-filters-dev libtf2-ros-dev libtf2-geometry-msgs-dev libtopic-tools-dev
  libtf2-sensor-msgs-dev liblaser-geometry-dev libdynamic-reconfigure-config-init-mutex-dev
  python3-dynamic-reconfigure libeigen3-dev libyaml-cpp-dev nlohmann-json3-dev libtinyxml2-dev libsdl-image1.2-dev liburdf-dev
  libconsole-bridge-dev liburdfdom-dev libdiagnostic-updater-dev libinteractive-markers-dev zlib1g-dev"
HIDWA_DEBIAN_COLCON="colcon python3-colcon-core python3-colcon-bash python3-colcon-cmake python3-colcon-ros python3-colcon-library-path
  python3-colcon-metadata python3-colcon-output python3-colcon-package-information
  python3-colcon-package-selection python3-colcon-pkg-config python3-colcon-recursive-crawl
  python3-colcon-test-result python3-colcon-parallel-executor"
# Debian 11 has no colcon: catkin builds there (build.sh).
if ! grep -qs '^VERSION_CODENAME=bullseye$' /etc/os-release; then HIDWA_DEBIAN_BUILD="$HIDWA_DEBIAN_BUILD $HIDWA_DEBIAN_COLCON"; fi
# A message's Python package is what rostopic echo needs to show it.
HIDWA_DEBIAN_RUN="python3-roslaunch rosout python3-rosparam python3-rostopic python3-rosnode rospack-tools rosbash
  python3-tf2-ros python3-actionlib python3-dynamic-reconfigure python3-diagnostic-msgs
  python3-geometry-msgs python3-map-msgs python3-move-base-msgs python3-nav-msgs python3-rosgraph-msgs python3-sensor-msgs
  python3-std-msgs python3-visualization-msgs python3-numpy python3-rosbag python3-yaml python3-scipy python3-matplotlib
  python3-tornado python3-pil python3-actionlib-msgs python3-tf2-msgs"
HIDWA_DEBIAN_TEST="ccache librostest-dev python3-rostest python3-rosunit libgtest-dev libgmock-dev libbenchmark-dev"
# With the run-time libraries of the Clang that clang-tidy brings: sanitizers and fuzzing.
HIDWA_DEBIAN_LINT="clang-format clang-tidy libclang-rt-dev cppcheck flake8 shellcheck codespell catkin-lint"
HIDWA_DEBIAN_BENCH="build-essential cmake python3 libeigen3-dev libyaml-cpp-dev nlohmann-json3-dev zlib1g-dev libbenchmark-dev"
HIDWA_DEBIAN_ATTACK="build-essential cmake python3 libeigen3-dev nlohmann-json3-dev libgtest-dev libyaml-cpp-dev zlib1g-dev"
# scripts/test --long coverage, and scripts/mutate. Fuzzing takes Clang with its run-time libraries, which may be packaged apart.
HIDWA_DEBIAN_COVERAGE="gcovr ninja-build"
HIDWA_DEBIAN_MUTATE="build-essential cmake ninja-build ccache python3 libeigen3-dev nlohmann-json3-dev libyaml-cpp-dev
  libconsole-bridge-dev liburdfdom-dev zlib1g-dev libgtest-dev"
HIDWA_DEBIAN_FUZZ="clang libclang-rt-dev"
# The operator's console: npm brings the browser's libraries; a browser tests the page.
HIDWA_DEBIAN_CONSOLE="npm"
HIDWA_DEBIAN_BROWSER="chromium chromium-driver python3-selenium"
# Other systems in folders of their own (scripts/platforms).
HIDWA_DEBIAN_PLATFORMS="mmdebstrap iproute2"
HIDWA_DEBIAN_GUI="rviz libgl1-mesa-dri ros-robot-state-publisher"

# Ubuntu 20.04 with ROS Noetic in /opt/ros/noetic: the real navigation stack is packaged there.
HIDWA_NOETIC_BUILD="build-essential cmake libeigen3-dev libyaml-cpp-dev nlohmann-json3-dev libconsole-bridge-dev liburdfdom-dev zlib1g-dev
  python3-colcon-common-extensions ros-noetic-catkin ros-noetic-navigation ros-noetic-diagnostic-updater
  ros-noetic-dynamic-reconfigure ros-noetic-pluginlib ros-noetic-rosbag ros-noetic-roscpp ros-noetic-rospy
  ros-noetic-tf2-ros ros-noetic-tf2-geometry-msgs ros-noetic-urdf ros-noetic-visualization-msgs"
HIDWA_NOETIC_RUN="ros-noetic-roslaunch ros-noetic-rosbash ros-noetic-actionlib ros-noetic-move-base-msgs
  ros-noetic-diagnostic-msgs ros-noetic-map-msgs ros-noetic-tf2-msgs
  python3-yaml python3-numpy python3-scipy python3-matplotlib python3-tornado python3-pil"
HIDWA_NOETIC_TEST="ccache libgtest-dev libgmock-dev libbenchmark-dev ros-noetic-rostest ros-noetic-rosunit"
HIDWA_NOETIC_LINT="python3-catkin-lint"  # other versions of the rest find other things
HIDWA_NOETIC_BENCH=$HIDWA_DEBIAN_BENCH
HIDWA_NOETIC_ATTACK=$HIDWA_DEBIAN_ATTACK
HIDWA_NOETIC_COVERAGE=$HIDWA_DEBIAN_COVERAGE
HIDWA_NOETIC_MUTATE=$HIDWA_DEBIAN_MUTATE
HIDWA_NOETIC_FUZZ="clang"  # its run-time libraries are in there
HIDWA_NOETIC_CONSOLE=$HIDWA_DEBIAN_CONSOLE
HIDWA_NOETIC_BROWSER="chromium-browser chromium-chromedriver python3-selenium"
HIDWA_NOETIC_PLATFORMS=$HIDWA_DEBIAN_PLATFORMS
HIDWA_NOETIC_GUI="ros-noetic-rviz ros-noetic-robot-state-publisher"

# hidwa_packages PURPOSE...: the names, for build, run, test, lint, bench, attack, coverage, mutate, fuzz, console, browser,
# platforms and gui.
hidwa_packages() {
  local family=DEBIAN purpose list
  if [ -d "$HIDWA_NOETIC" ]; then family=NOETIC; fi
  for purpose in "$@"; do
    list=HIDWA_${family}_${purpose^^}
    printf '%s ' ${!list}
  done
}

# Those of the names given that are not installed.
hidwa_not_installed() {
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || printf '%s ' "$name"
  done
}

hidwa_apt() {
  local as_root=()
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || fail "neither root nor sudo; as root run: apt-get $*"
    as_root=(sudo)
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q "$@"
}

# hidwa_install PURPOSE...: installs what is missing. HIDWA_INSTALL=no only says so.
hidwa_install() {
  local names
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
    fail "no apt here: install ROS 1 with move_base's messages by hand and set HIDWA_INSTALL=skip; needed: $(hidwa_packages "$@")"
  # shellcheck disable=SC2046
  names=$(hidwa_not_installed $(hidwa_packages "$@"))
  if [ -z "$names" ]; then return 0; fi
  if [ "${HIDWA_INSTALL:-yes}" = no ]; then fail "not installed (HIDWA_INSTALL=no): $names"; fi
  say "installing with apt: $names"
  # The lists on the disk may be empty or old: only then are they fetched.
  # shellcheck disable=SC2086
  hidwa_apt install -y --no-install-recommends $names ||
    { say "fetching the package lists"; hidwa_apt update && hidwa_apt install -y --no-install-recommends $names; } ||
    fail "apt could not install: $names"
}
