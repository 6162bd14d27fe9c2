# The operator's console: its server, its page, and the browser's libraries, where scripts/console_libraries has put them
# (by npm). Without them the page works in its plain form.
set(HIDWA_CONSOLE_LIBRARIES "" CACHE PATH "node_modules with the browser's libraries for the operator's page; empty: none")

install(PROGRAMS console/console DESTINATION ${HIDWA_BIN_DESTINATION})
install(DIRECTORY console/hidwa_console DESTINATION ${HIDWA_BIN_DESTINATION}/lib FILES_MATCHING PATTERN "*.py")
install(DIRECTORY console/page DESTINATION ${HIDWA_SHARE_DESTINATION}/console OPTIONAL)
# What the page loads of three; all of it would be 24 MB. Looked for when installing: npm may have run after the configuration.
install(CODE "
  set(three \"${HIDWA_CONSOLE_LIBRARIES}/three\")
  file(GLOB modules \"\${three}/build/three.module.js\" \"\${three}/build/three.core.js\" \"\${three}/LICENSE\")
  foreach(file IN LISTS modules)
    file(RELATIVE_PATH path \"\${three}\" \"\${file}\")
    get_filename_component(folder \"\${path}\" DIRECTORY)
    file(INSTALL \"\${file}\" DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${HIDWA_SHARE_DESTINATION}/console/lib/three/\${folder}\")
  endforeach()")
