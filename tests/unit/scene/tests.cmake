cell_add_test(unit/scene/sec_messages_test.cc LINK cell_sec cell_task)
cell_add_test(unit/scene/relation_layers_test.cc LINK cell_scene)
