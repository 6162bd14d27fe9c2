# The operator's console: its server, its page, and the browser's libraries, where scripts/console_libraries has put them
# (by npm). Without them the page works in its plain form.
set(HIDWA_CONSOLE_LIBRARIES "" CACHE PATH "node_modules with the browser's libraries for the operator's page; empty: none")

install(PROGRAMS console/console DESTINATION ${HIDWA_BIN_DESTINATION})
install(DIRECTORY console/hidwa_console DESTINATION ${HIDWA_BIN_DESTINATION}/lib FILES_MATCHING PATTERN "*.py")
install(DIRECTORY console/page DESTINATION ${HIDWA_SHARE_DESTINATION}/console OPTIONAL)
if(HIDWA_CONSOLE_LIBRARIES)
  # What the page loads of three; all of it would be 24 MB. OPTIONAL: the folder may be gone or not yet there.
  install(FILES ${HIDWA_CONSOLE_LIBRARIES}/three/build/three.module.js ${HIDWA_CONSOLE_LIBRARIES}/three/build/three.core.js
    DESTINATION ${HIDWA_SHARE_DESTINATION}/console/lib/three/build OPTIONAL)
  install(FILES ${HIDWA_CONSOLE_LIBRARIES}/three/LICENSE DESTINATION ${HIDWA_SHARE_DESTINATION}/console/lib/three OPTIONAL)
endif()
