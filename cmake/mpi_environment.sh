# To be sourced: what lets mpirun start any number of ranks on any number of processors, as root too, without binding them.
# Harmless where it is not needed. Open MPI 4 reads the variables OMPI_MCA_, 5 and 6 those with PRTE_MCA_.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
export OMPI_MCA_hwloc_base_binding_policy=none PRTE_MCA_hwloc_default_binding_policy=none
export OMPI_MCA_mpi_yield_when_idle=1
