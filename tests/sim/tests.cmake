file(GLOB areas CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.tests.cmake)
foreach(area ${areas})
  include(${area})
endforeach()
