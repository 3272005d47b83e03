# Set when ctest has found the tests (COST, see CMakeLists.txt). Seconds on two quiet cores on 2026-11-23: 44 gl.Gate,
# 43 commands.Pictures, 37 commands.ExitCodes, 16 to 25 the others. The windows (COST 70 and 95), one at a time and
# 459 s together, go beside these from the start.
set_tests_properties(gl.Gate commands.Pictures PROPERTIES COST 100)
set_tests_properties(commands.ExitCodes gl.Truth gl.PictureTest commands.Measured texture_set.TextureSet commands.Response
                     commands.ChartRun render_data.FarFields PROPERTIES COST 90)
