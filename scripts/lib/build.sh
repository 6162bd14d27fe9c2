# SPDX-License-Identifier: BSD-3-Clause
# The colcon build. Sourced after packages.sh, with the underlay in the environment.

# Compilers at a time: one a core, but a gigabyte and a half of memory each.
hidwa_jobs() {
  local memory jobs
  memory=$(awk '/^MemAvailable:/ {print int($2 / 1572864)}' /proc/meminfo)
  jobs=$(nproc)
  if [ "$memory" -lt "$jobs" ]; then jobs=$memory; fi
  if [ "$jobs" -lt 1 ]; then jobs=1; fi
  printf '%s\n' "${HIDWA_JOBS:-$jobs}"
}

# Libraries built against one host must not meet another: a change of host starts from nothing.
hidwa_keep_or_clean() {
  local host=$1 stamp=$HIDWA_SPACE/build/host
  if [ -f "$stamp" ] && [ "$(cat "$stamp")" != "$host" ]; then
    say "the host changed: building from nothing"
    rm -rf "$HIDWA_SPACE/build" "$HIDWA_SPACE/install"
  fi
  mkdir -p "$HIDWA_SPACE/build"
  printf '%s\n' "$host" > "$stamp"
}

# hidwa_build [CMAKE_ARGUMENT...]
hidwa_build() {
  local missing bases=("$HIDWA_ROOT") package tests=()
  missing=$(hidwa_missing_host)
  for package in $missing; do bases+=("$HIDWA_ROOT/compat/$package"); done
  say "host: ${missing:+compat for ${missing//$'\n'/, }; }underlay ${HIDWA_UNDERLAY:-none}"
  hidwa_keep_or_clean "compat: ${missing//$'\n'/ }; underlay: ${HIDWA_UNDERLAY:-}"
  # Tests stay out of a user's build; a build that has them keeps them.
  if ! grep -q 'HIDWA_TESTS:[A-Z]*=ON' "$HIDWA_SPACE/build/hidwa_local_planner/CMakeCache.txt" 2>/dev/null; then
    tests=(-DHIDWA_TESTS=OFF -DCOMPAT_TESTS=OFF)
  fi
  export MAKEFLAGS="-j$(hidwa_jobs)"
  (cd "$HIDWA_SPACE" && colcon build --merge-install --executor sequential --base-paths "${bases[@]}" \
    --build-base build --install-base install --event-handlers console_cohesion- console_start_end+ \
    --cmake-args -DCMAKE_BUILD_TYPE=Release -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DPython3_EXECUTABLE=/usr/bin/python3 --no-warn-unused-cli ${tests[@]+"${tests[@]}"} "$@") ||
    fail "the build failed; the whole story is in $HIDWA_SPACE/log/latest_build"
}
