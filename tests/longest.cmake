# Set when ctest has found the tests (COST, see CMakeLists.txt).
set_tests_properties(commands.ChartRun.measures_every_combination_and_takes_up_where_it_was_cut PROPERTIES COST 100)
