# Compiles every entry point of shaders/passes to SPIR-V at build time and embeds it as an array of words. Those that
# trace rays, and so include lib/traces.glsl, are there twice: as NAME, and for hardware rays as NAME+ray_query.
function(manylight_embed_shaders target)
  file(GLOB entry_points CONFIGURE_DEPENDS
    ${CMAKE_SOURCE_DIR}/shaders/passes/*.comp ${CMAKE_SOURCE_DIR}/shaders/passes/*.vert
    ${CMAKE_SOURCE_DIR}/shaders/passes/*.frag)
  set(generated ${CMAKE_BINARY_DIR}/generated/shaders)
  file(MAKE_DIRECTORY ${generated})
  set(headers "")
  set(includes "")
  set(rows "")
  foreach(source ${entry_points})
    get_filename_component(file ${source} NAME)
    set(variants ${file})
    file(STRINGS ${source} traces REGEX "#include \"shaders/lib/traces.glsl\"")
    if(traces)
      list(APPEND variants ${file}+ray_query)
    endif()
    foreach(variant ${variants})
      string(REGEX REPLACE "[.+]" "_" symbol ${variant})
      set(header ${generated}/${variant}.spv.h)
      set(definition "")
      if(NOT variant STREQUAL file)
        set(definition -DMANYLIGHT_RAY_QUERY)
      endif()
      add_custom_command(OUTPUT ${header}
        COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.3 -I${CMAKE_SOURCE_DIR} ${definition}
                --vn ${symbol} --depfile ${header}.d -o ${header} ${source}
        DEPENDS ${source} DEPFILE ${header}.d
        COMMENT "glslang ${variant}" VERBATIM)
      list(APPEND headers ${header})
      string(APPEND includes "#include \"${variant}.spv.h\"\n")
      string(APPEND rows "    {\"${variant}\", ${symbol}, sizeof(${symbol})},\n")
    endforeach()
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${entry_points})
  file(CONFIGURE OUTPUT ${generated}/embedded_shaders.inc CONTENT
"${includes}
static constexpr EmbeddedShader kEmbeddedShaders[] = {
${rows}};
" @ONLY)
  add_custom_target(${target}_spirv DEPENDS ${headers})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_spirv)
  target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${generated}>)
endfunction()
