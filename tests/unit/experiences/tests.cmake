cell_add_test(unit/experiences/effects_on_others_test.cc
  LINK cell_experiences cell_planner cell_task)
cell_add_test(unit/experiences/experience_text_test.cc
  LINK cell_experiences cell_planner cell_task)
cell_add_test(unit/experiences/experience_tracer_test.cc
  LINK cell_experiences cell_planner cell_task)
cell_add_test(unit/experiences/learned_actions_test.cc
  LINK cell_experiences cell_planner cell_task)
cell_add_test(unit/experiences/rule_conversion_test.cc
  LINK cell_experiences cell_planner cell_task)
cell_add_test(unit/experiences/rule_lessons_test.cc
  LINK cell_experiences cell_planner cell_task)
cell_add_test(unit/experiences/task_experience_test.cc
  LINK cell_experiences cell_planner cell_task)
