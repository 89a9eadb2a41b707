cell_add_test(unit/assemblies/annotation_reader_test.cc LINK cell_assemblies)
cell_add_test(unit/assemblies/assembly_model_test.cc LINK cell_assemblies)
cell_add_test(unit/assemblies/sequence_judge_test.cc LINK cell_assemblies)
