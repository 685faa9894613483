# SPDX-License-Identifier: BSD-3-Clause
# To be sourced: lets `"${mpirun[@]}" -np N ...` start any number of ranks on this machine, as root too, bound to no
# processor. Options rather than variables, whose names change from Open MPI 4 to 5 to 6.
mpirun=(mpirun --oversubscribe --bind-to none)
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1
# As cmake/StromaTest.cmake says.
export OMPI_MCA_btl=^tcp,ofi LD_BIND_NOW=1
