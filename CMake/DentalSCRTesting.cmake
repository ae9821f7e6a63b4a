# GoogleTest drivers, one a module, under ITK's name for it.
include(GoogleTest)

# Tests on real files read ../shared where it is there and skip with a message where it is not.
set(DENTALSCR_SHARED_DIR "${CMAKE_CURRENT_SOURCE_DIR}/../shared" CACHE PATH "Folder with the shared cases")

function(CreateGoogleTestDriver KIT KIT_LIBS KitTests)
  set(driver ${KIT}GTestDriver)
  add_executable(${driver} ${KitTests})
  dentalscr_target_settings(${driver})
  target_link_libraries(${driver} PRIVATE ${KIT_LIBS} GTest::gtest GTest::gtest_main)
  target_include_directories(${driver} PRIVATE "${DentalSCR_SOURCE_DIR}/Testing/Support")
  target_include_directories(${driver} SYSTEM PRIVATE ${ITK_INCLUDE_DIRS})
  target_compile_definitions(${driver} PRIVATE
    DENTALSCR_SHARED_DIR="${DENTALSCR_SHARED_DIR}"
    DENTALSCR_TEST_OUTPUT_DIR="${CMAKE_CURRENT_BINARY_DIR}")
  gtest_discover_tests(${driver} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600 LABELS ${KIT})
endfunction()
