# The operator's console: its server, its page, and the browser's libraries, which scripts/console_libraries has put into
# HIDWA_CONSOLE_LIBRARIES (by npm). Without them the page works in its plain form.
install(PROGRAMS console/console DESTINATION ${HIDWA_BIN_DESTINATION})
install(DIRECTORY console/hidwa_console DESTINATION ${HIDWA_BIN_DESTINATION}/lib FILES_MATCHING PATTERN "*.py")
if(EXISTS ${PROJECT_SOURCE_DIR}/console/page)
  install(DIRECTORY console/page DESTINATION ${HIDWA_SHARE_DESTINATION}/console)
endif()
