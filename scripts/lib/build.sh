# SPDX-License-Identifier: BSD-3-Clause
# The build of a workspace. Sourced after packages.sh, with the underlay in the environment.

# Compilers at a time: one a core, but a gigabyte and a half of memory each.
hidwa_jobs() {
  local memory jobs
  memory=$(awk '/^MemAvailable:/ {print int($2 / 1572864)}' /proc/meminfo)
  jobs=$(nproc)
  if [ "$memory" -lt "$jobs" ]; then jobs=$memory; fi
  if [ "$jobs" -lt 1 ]; then jobs=1; fi
  printf '%s\n' "${HIDWA_JOBS:-$jobs}"
}

# hidwa_take_host HOST: libraries built against one host must not meet another. What compat/ gave and what was installed goes,
# and so do packages built upon it. The planner's own build folder stays, but looks for every package anew: what sees other
# headers then is compiled again, and nothing else.
hidwa_take_host() {
  local host=$1 stamp=$HIDWA_SPACE/build/host own=$HIDWA_SPACE/build/hidwa_local_planner part
  if [ -f "$stamp" ] && [ "$(cat "$stamp")" != "$host" ]; then
    say "the host changed: building anew what depends on it"
    for part in nav_core costmap_2d map_server move_base tests/ros tests/robot; do rm -rf "$HIDWA_SPACE/build/$part"; done
    rm -rf "$HIDWA_SPACE/install" "$own/cmake_args.last"  # without the latter colcon configures
    if [ -f "$own/CMakeCache.txt" ]; then sed -i -E 's/^([^:]*_DIR):PATH=.*/\1:PATH=\1-NOTFOUND/' "$own/CMakeCache.txt"; fi
  fi
  mkdir -p "$HIDWA_SPACE/build"
  printf '%s\n' "$host" > "$stamp"
}

# hidwa_built_with NAME: whether the build that stands has this option ON.
hidwa_built_with() {
  grep -q "^$1:[A-Z]*=ON" "$HIDWA_SPACE/build/hidwa_local_planner/CMakeCache.txt" 2>/dev/null
}

# Says so where a source file is newer than the last build.
hidwa_check_age() {
  local newer
  [ -e "$HIDWA_SPACE/log/latest_build" ] || return 0
  newer=$(find "$HIDWA_ROOT"/{include,src,lab,msg,CMakeLists.txt} -newer "$HIDWA_SPACE/log/latest_build" -type f -print -quit)
  [ -z "$newer" ] || say "${newer#"$HIDWA_ROOT/"} is newer than the last build: scripts/build --all builds anew" >&2
}

# hidwa_workspace FOLDER PACKAGE_FOLDER... -- CMAKE_ARGUMENT...: builds packages and their tests into FOLDER/{build,install,log}, by
# colcon, or by catkin where there is no colcon (Debian 11). Each package has its build folder in FOLDER/build either way.
hidwa_workspace() {
  local packages=() log
  mkdir -p "$1"
  cd "$1" || return
  shift
  while [ "$1" != -- ]; do packages+=("$1"); shift; done
  shift
  if command -v colcon >/dev/null; then
    colcon build --merge-install --executor sequential --base-paths "${packages[@]}" --build-base build --install-base install \
      --event-handlers console_cohesion- console_start_end+ console_direct+ console_stderr- --cmake-args "$@"
  else
    log=log/build_$(date +%F_%H-%M-%S)
    rm -rf build/source
    mkdir -p build/source "$log"
    ln -sfn "${log#log/}" log/latest_build
    ln -s "${packages[@]}" build/source
    PYTHONUNBUFFERED=1 catkin_make_isolated --source build/source --build build --devel build/devel --merge --install \
      --install-space install --catkin-make-args all tests --cmake-args "$@" 2>&1 | tee "$log/stdout_stderr.log"
  fi
}

# hidwa_build [CMAKE_ARGUMENT...]
hidwa_build() {
  local host missing bases=("$HIDWA_ROOT") package parts=()
  host=$(hidwa_host)
  missing=$(sed -n 's/ compat$//p' <<< "$host")
  for package in $missing; do bases+=("$HIDWA_ROOT/compat/$package"); done
  say "host: ${missing:+compat for ${missing//$'\n'/, }; }underlay ${HIDWA_UNDERLAY:-none}"
  hidwa_take_host "$host"$'\n'"underlay ${HIDWA_UNDERLAY:-none}"
  # Tests, study and replay stay out of a first build; a build that has them keeps them.
  hidwa_built_with HIDWA_TESTS || parts+=(-DHIDWA_TESTS=OFF -DCOMPAT_TESTS=OFF)
  hidwa_built_with HIDWA_TOOLS || parts+=(-DHIDWA_TOOLS=demo)
  [ -d "$HIDWA_SPACE/build/hidwa_local_planner" ] || parts+=(-DHIDWA_UNITY=ON)
  export MAKEFLAGS="-j$(hidwa_jobs)"
  export HIDWA_WITH_TOOLS=1  # for package.xml: what a robot does without is a dependency here
  (hidwa_workspace "$HIDWA_SPACE" "${bases[@]}" -- -DCMAKE_BUILD_TYPE=Release -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DPython3_EXECUTABLE=/usr/bin/python3 -DHIDWA_CONSOLE_LIBRARIES="$HIDWA_SPACE/build/console/node_modules" \
    -DHIDWA_WERROR="$(hidwa_werror)" --no-warn-unused-cli ${parts[@]+"${parts[@]}"} "$@" |
    /usr/bin/python3 "$HIDWA_LIB/hidwa_tools/build_progress.py") ||
    fail "the build failed; its whole output is in $HIDWA_SPACE/log/latest_build"
}

# hidwa_rostests: the packages of test/ros, upon what was installed.
hidwa_rostests() {
  local manifests=("$HIDWA_ROOT"/test/ros/*/package.xml)
  . "$HIDWA_ROOT/scripts/env"
  # C++14, the default of GCC 9: a package with critics is lifted from it by this one.
  MAKEFLAGS="-j$(hidwa_jobs)" hidwa_workspace "$HIDWA_SPACE/build/tests/ros" "${manifests[@]%/package.xml}" -- \
    -DCMAKE_CXX_FLAGS=-std=gnu++14 -DHIDWA_WERROR="$(hidwa_werror)" -DCMAKE_BUILD_TYPE=Release \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 --no-warn-unused-cli
}
