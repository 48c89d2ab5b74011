# One interface target, MortarContact_dealii, with what deal.II's variables say,
# on every version from 9.4 on. (deal_ii_setup_target() uses the plain signature
# of target_link_libraries and cannot be exported.) Installed with the package.
if(NOT DEAL_II_TARGET_CONFIG_INCLUDED)
  include(${DEAL_II_TARGET_CONFIG})
  set(DEAL_II_TARGET_CONFIG_INCLUDED TRUE)
endif()

foreach(_build DEBUG RELEASE)
  string(TOLOWER ${_build} _lower)
  set(_target MortarContact_dealii_${_lower})
  if(NOT TARGET ${_target} AND _build IN_LIST DEAL_II_BUILD_TYPES)
    add_library(${_target} INTERFACE IMPORTED GLOBAL)
    separate_arguments(_compile UNIX_COMMAND
      "${DEAL_II_CXX_FLAGS} ${DEAL_II_CXX_FLAGS_${_build}}")
    if(_build STREQUAL "DEBUG")
      # means nothing without optimisation, and warns
      list(REMOVE_ITEM _compile "-D_FORTIFY_SOURCE=2")
    endif()
    separate_arguments(_link UNIX_COMMAND
      "${DEAL_II_LINKER_FLAGS} ${DEAL_II_LINKER_FLAGS_${_build}}")
    if(DEAL_II_VERSION VERSION_LESS 9.5)
      # from 9.5 on, deal.II's own targets carry these
      target_include_directories(${_target} SYSTEM INTERFACE
        ${DEAL_II_INCLUDE_DIRS})
      target_compile_definitions(${_target} INTERFACE
        ${DEAL_II_USER_DEFINITIONS} ${DEAL_II_USER_DEFINITIONS_${_build}})
    endif()
    target_compile_options(${_target} INTERFACE
      "$<$<COMPILE_LANGUAGE:CXX>:${_compile}>")
    target_link_options(${_target} INTERFACE ${_link})
    target_link_libraries(${_target} INTERFACE ${DEAL_II_TARGET_${_build}})
  endif()
endforeach()

if(NOT TARGET MortarContact_dealii)
  add_library(MortarContact_dealii INTERFACE IMPORTED GLOBAL)
  if(TARGET MortarContact_dealii_debug AND TARGET MortarContact_dealii_release)
    target_link_libraries(MortarContact_dealii INTERFACE
      "$<IF:$<CONFIG:Debug>,MortarContact_dealii_debug,MortarContact_dealii_release>")
  elseif(TARGET MortarContact_dealii_debug)
    target_link_libraries(MortarContact_dealii INTERFACE
      MortarContact_dealii_debug)
  else()
    target_link_libraries(MortarContact_dealii INTERFACE
      MortarContact_dealii_release)
  endif()
endif()
