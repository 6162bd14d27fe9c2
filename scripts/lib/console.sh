# SPDX-License-Identifier: BSD-3-Clause
# What the operator's page takes from npm. Sourced after packages.sh.

HIDWA_CONSOLE_SPACE=$HIDWA_SPACE/build/console  # its node_modules hold what the tests need too, where they were asked for

# hidwa_console_libraries [dev]: installs the browser's libraries into the build space, as console/package-lock.json names them; with
# `dev` also what the page's tests need. Where npm is missing, or cannot do it, this says so: the page has a plain form.
hidwa_console_libraries() {
  local wanted=production stamp=$HIDWA_CONSOLE_SPACE/installed
  if [ "${1:-}" = dev ]; then wanted=development; fi
  if ! command -v npm >/dev/null; then
    say "no npm here: the page comes without its view from on board (apt-get install npm, then again)"
    return 0
  fi
  mkdir -p "$HIDWA_CONSOLE_SPACE"
  if [ -f "$stamp" ] && [ "$stamp" -nt "$HIDWA_ROOT/console/package-lock.json" ] && grep -qx "$wanted\|development" "$stamp"; then return 0; fi
  if [ "${HIDWA_INSTALL:-yes}" = no ]; then fail "not installed (HIDWA_INSTALL=no): the page's libraries, by npm"; fi
  cp "$HIDWA_ROOT/console/package.json" "$HIDWA_ROOT/console/package-lock.json" "$HIDWA_CONSOLE_SPACE"
  say "installing the page's libraries with npm"
  # NODE_ENV: npm 6 and its successors know different options for this. Nothing of a package is run.
  if (cd "$HIDWA_CONSOLE_SPACE" && NODE_ENV=$wanted npm ci --ignore-scripts --no-audit --no-fund --loglevel=error); then
    printf '%s\n' "$wanted" > "$stamp"
  else
    rm -f "$stamp"
    say "npm could not install them: the page comes without its view from on board"
  fi
}

# Whether what npm brought is in the install space too; also true where npm brought nothing.
hidwa_console_installed() {
  [ ! -d "$HIDWA_CONSOLE_SPACE/node_modules/three" ] || [ -d "$HIDWA_SPACE/install/share/hidwa_local_planner/console/lib/three" ]
}
