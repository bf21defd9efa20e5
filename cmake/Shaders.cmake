# Compiles every entry point of shaders/passes to SPIR-V at build time and embeds it as an array of words.
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
    string(REPLACE "." "_" symbol ${file})
    set(header ${generated}/${file}.spv.h)
    add_custom_command(OUTPUT ${header}
      COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.3 -I${CMAKE_SOURCE_DIR}
              --vn ${symbol} --depfile ${header}.d -o ${header} ${source}
      DEPENDS ${source} DEPFILE ${header}.d
      COMMENT "glslang ${file}" VERBATIM)
    list(APPEND headers ${header})
    string(APPEND includes "#include \"${file}.spv.h\"\n")
    string(APPEND rows "    {\"${file}\", ${symbol}, sizeof(${symbol})},\n")
  endforeach()
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
