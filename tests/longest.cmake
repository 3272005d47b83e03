# Set when ctest has found the tests (COST, see CMakeLists.txt).
set_tests_properties(gl.Gate commands.Pictures PROPERTIES COST 100)
set_tests_properties(commands.ChartRun render_data.FarFields gl.PictureTest PROPERTIES COST 90)
