# The Debian package: `cpack -G DEB` in a release build. The programs' own rooms install them; here comes what belongs to a desktop.
include(GNUInstallDirs)
foreach(program glisson-cli glisson-import)
  if(TARGET ${program})
    install(TARGETS ${program})
  endif()
endforeach()
if(TARGET glisson)
  install(TARGETS glisson)
  install(FILES installer/glisson.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES installer/glisson-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME glisson.xml)
  install(FILES resources/glisson.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()
install(PROGRAMS installer/slurm/submit installer/slurm/evaluate.sbatch DESTINATION ${CMAKE_INSTALL_DATADIR}/glisson/slurm)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME glisson)
set(CPACK_PACKAGE_VENDOR Glisson)
set(CPACK_PACKAGE_CONTACT "Glisson maintainers <glisson@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "planning of liver resections")
set(CPACK_PACKAGE_DESCRIPTION
    "Glisson loads a CT and segmentations of the liver, reconstructs the parenchyma by Poisson surface reconstruction and vessels and\n\
tumours by marching cubes, shows the model with a virtual resection plane, gives volumes and margins, and exports the plan for\n\
navigation in the operating room. It comes with a synthetic patient to try it on. Not for clinical use.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What no library name tells: icons as SVG, letters, the German of Qt's own
# dialogs, and OpenGL where there is no graphics card. Added to what shlibdeps finds.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6svg6, qt6-translations-l10n, fonts-dejavu-core, libgl1-mesa-dri")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
include(CPack)
