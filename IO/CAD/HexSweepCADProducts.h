// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From the kernel's document to solids with names, colours and their place among the
 * products. Private to the module.
 */
#ifndef HexSweepCADProducts_h
#define HexSweepCADProducts_h

#include "HexSweepCADModel.h"

#include <TDocStd_Document.hxx>

namespace hexsweep
{
/// All solids below all free shapes of a document; each instance of a part is a solid of its own.
CADModel readProducts(const opencascade::handle<TDocStd_Document>& document);

/// All solids of a shape without names.
CADModel productsOfShape(const TopoDS_Shape& shape);
}

#endif
