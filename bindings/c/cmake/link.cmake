# Makes the name without version, for the linker, a link to the one with version.
get_filename_component(name "${VERSIONED}" NAME)
if(NOT VERSIONED STREQUAL SHARED)
    file(CREATE_LINK "${name}" "${SHARED}" SYMBOLIC)
endif()
