cell_add_test(unit/recognizer/recognition_test.cc LINK cell_recognizer cell_task cell_tracker)
cell_add_test(unit/recognizer/learning_test.cc LINK cell_recognizer cell_task cell_tracker)
