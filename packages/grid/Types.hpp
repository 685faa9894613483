// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Names for the Tpetra types that hold grid unknowns.

#include <Teuchos_RCP.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Operator.hpp>
#include <Tpetra_Vector.hpp>

namespace stroma::grid {

using Map = Tpetra::Map<>;
using Vector = Tpetra::Vector<double>;
using MultiVector = Tpetra::MultiVector<double>;
using Operator = Tpetra::Operator<double>;
using LocalOrdinal = Map::local_ordinal_type;
using GlobalOrdinal = Map::global_ordinal_type;
using Device = Map::device_type;
using ExecutionSpace = Device::execution_space;
using Teuchos::RCP;

/// A vector per node of a box of nodes: (node, component); x runs fastest in node, as in grid::Box.
using NodeView = Kokkos::View<double* [3], Kokkos::LayoutRight, Device>;
using ConstNodeView = Kokkos::View<const double* [3], Kokkos::LayoutRight, Device>;

}  // namespace stroma::grid
