cell_add_test(unit/plan_search_test.cc LINK cell_planner)
cell_add_test(unit/cranfield_planning_test.cc LINK cell_planner cell_parts)
cell_add_test(unit/monitor_test.cc LINK cell_planner cell_parts)
cell_add_test(unit/planner_test.cc LINK cell_planner cell_parts)
