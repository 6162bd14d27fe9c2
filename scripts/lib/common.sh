# SPDX-License-Identifier: BSD-3-Clause
# Where things are, and an environment in which ROS tools work.
# Sourced by bash; sets HIDWA_ROOT (the source tree), HIDWA_LIB (this folder) and HIDWA_SPACE (where build, install
# and log lie; default: the source tree).

HIDWA_LIB=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
HIDWA_ROOT=$(cd -- "$HIDWA_LIB/../.." && pwd -P)
HIDWA_SPACE=${HIDWA_SPACE:-$HIDWA_ROOT}
HIDWA_NOETIC=${HIDWA_NOETIC:-/opt/ros/noetic}

# A second Python in front of /usr/bin (pyenv, conda, a virtual environment) breaks catkin, rospy and every
# "env python3" tool of ROS: folders that bring one are taken out of PATH, the system's own stand first.
hidwa_clean_path() {
  local clean=/usr/bin:/bin entry entries
  IFS=: read -r -a entries <<< "${PATH:-}:/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
  for entry in "${entries[@]}"; do
    case ":$clean:" in *":$entry:"*) continue ;; esac
    if [ -z "$entry" ]; then continue; fi
    if [ "$entry" != /usr/local/bin ] && { [ -e "$entry/python3" ] || [ -e "$entry/python" ]; }; then
      case $entry in /usr/*|/bin|/sbin) ;; *) continue ;; esac
    fi
    clean=$clean:$entry
  done
  export PATH=$clean
  unset PYTHONHOME VIRTUAL_ENV PYENV_VERSION
  hidwa_leave_install
}

# In a shell that has sourced scripts/env, what was built before would count as part of the host: compat/ would be taken for
# the real navigation stack.
hidwa_leave_install() {
  local name entry entries clean
  for name in PATH CMAKE_PREFIX_PATH COLCON_PREFIX_PATH ROS_PACKAGE_PATH LD_LIBRARY_PATH PYTHONPATH PKG_CONFIG_PATH; do
    case ":${!name:-}:" in *":$HIDWA_SPACE/install"[:/]*) ;; *) continue ;; esac
    IFS=: read -r -a entries <<< "${!name}"
    clean=
    for entry in "${entries[@]}"; do
      case $entry/ in "$HIDWA_SPACE"/install/*) ;; *) clean=$clean:$entry ;; esac
    done
    export "$name=${clean#:}"
  done
}

# hidwa_source FILE: sources another workspace's setup file; such files know neither `set -e` nor `set -u`. Without --extend
# catkin's would take the workspaces away that were sourced before: the user's own.
hidwa_source() {
  local options=$- status=0
  set +eu
  # shellcheck disable=SC1090
  . "$1" --extend || status=$?
  case $options in *e*) set -e ;; esac
  case $options in *u*) set -u ;; esac
  return "$status"
}

# What is below ours, on top of what the user has sourced: ROS Noetic where it is installed, then HIDWA_UNDERLAY (an
# install or devel space).
hidwa_underlay() {
  local setup
  if [ -f "$HIDWA_NOETIC/setup.bash" ]; then
    hidwa_source "$HIDWA_NOETIC/setup.bash" || return
  fi
  if [ -z "${HIDWA_UNDERLAY:-}" ]; then return 0; fi
  setup=$HIDWA_UNDERLAY/setup.bash
  if [ ! -f "$setup" ]; then
    printf 'HIDWA_UNDERLAY=%s holds no setup.bash; give the install space of a colcon or catkin workspace\n' \
      "$HIDWA_UNDERLAY" >&2
    return 1
  fi
  hidwa_source "$setup"
}

# The packages of the host, each with its folder, or with `compat` where neither the system nor the underlay has it.
hidwa_host() {
  local package
  for package in nav_core costmap_2d map_server move_base; do
    printf '%s %s\n' "$package" "$(rospack find "$package" 2>/dev/null || printf compat)"
  done
}

# Warnings are errors with the compiler that this is developed with, GCC 12; others warn differently. HIDWA_WERROR says otherwise.
hidwa_werror() {
  local version=OFF
  if [ "$("${CXX:-g++}" -dumpversion 2>/dev/null)" = 12 ]; then version=ON; fi
  printf '%s\n' "${HIDWA_WERROR:-$version}"
}
