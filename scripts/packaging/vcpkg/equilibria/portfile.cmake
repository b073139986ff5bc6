# The headers, as `cmake --install` gives them, from the tree in which this overlay port stands:
#   vcpkg install equilibria --overlay-ports=scripts/packaging/vcpkg
# vcpkg knows a port again by its own files, not by the tree: after a change of the tree `vcpkg remove equilibria` first, and
# install with --no-binarycaching.
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../../.." ABSOLUTE)
set(VCPKG_BUILD_TYPE release) # nothing is compiled

vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        -DEQUILIBRIA_BUILD_TESTS=OFF
        -DEQUILIBRIA_BUILD_EXAMPLES=OFF
        -DEQUILIBRIA_BUILD_COMPILED=OFF
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/${PORT})
vcpkg_fixup_pkgconfig()

file(INSTALL "${CURRENT_PORT_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
