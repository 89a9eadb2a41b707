cell_add_test(unit/plan_search_test.cc LINK cell_planner)



