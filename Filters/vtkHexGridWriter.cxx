// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexGridWriter.h"

#include "Core/Common/Errors.h"

#include "HexSweepBlockWriting.h"
#include "HexSweepInputCheck.h"

#include <vtkDataArray.h>
#include <vtkDataCompressor.h>
#include <vtkErrorCode.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>

#include <vtksys/SystemTools.hxx>

#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkInformationInformationVectorKey.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <new>
#include <type_traits>
#include <vector>

vtkStandardNewMacro(vtkHexGridWriter);

namespace
{
template <typename Value>
std::array<double, 2> rangeOf(const Value* values, vtkIdType count)
{
  constexpr vtkIdType AtOnce = 1 << 16;
  const vtkIdType pieces = (count + AtOnce - 1) / AtOnce;
  std::vector<std::array<Value, 2>> found(static_cast<std::size_t>(pieces));
  vtkSMPTools::For(0, pieces, 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType p = begin; p < end; ++p)
    {
      const vtkIdType last = std::min((p + 1) * AtOnce, count);
      Value low = values[p * AtOnce];
      Value high = low;
      for (vtkIdType i = p * AtOnce; i < last; ++i)
      {
        low = std::min(low, values[i]);
        high = std::max(high, values[i]);
      }
      found[static_cast<std::size_t>(p)] = { low, high };
    }
  });
  std::array<Value, 2> range = found.front();
  for (const std::array<Value, 2>& piece : found)
  {
    range = { std::min(range[0], piece[0]), std::max(range[1], piece[1]) };
  }
  return { static_cast<double>(range[0]), static_cast<double>(range[1]) };
}

/// Leaves the range of whole numbers where the array itself would, and looks for it.
void rememberRange(vtkDataArray* array)
{
  vtkInformation* information = array->GetInformation();
  if (information->Has(vtkAbstractArray::PER_COMPONENT()))
  {
    return;
  }
  std::array<double, 2> range{ 1.0, 0.0 };
  switch (array->GetDataType())
  {
    vtkTemplateMacro(if constexpr (std::is_integral_v<VTK_TT>) {
      range =
        rangeOf(static_cast<const VTK_TT*>(array->GetVoidPointer(0)), array->GetNumberOfValues());
    });
  }
  if (range[0] > range[1])
  {
    return;
  }
  vtkNew<vtkInformationVector> components;
  vtkNew<vtkInformation> component;
  component->Set(vtkDataArray::COMPONENT_RANGE(), range.data(), 2);
  components->SetInformationObject(0, component);
  information->Set(vtkAbstractArray::PER_COMPONENT(), components);
}
}

//------------------------------------------------------------------------------
int vtkHexGridWriter::WriteInternal()
{
  try
  {
    hexsweep::checkData(this->GetInput(), "input");
  }
  catch (const hexsweep::InvalidInput& problem)
  {
    // Before a file is opened: an old one of this name stays.
    vtkErrorMacro(<< problem.what());
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
  try
  {
    return this->Superclass::WriteInternal();
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro("not enough memory to write this mesh.");
    this->SetErrorCode(vtkErrorCode::UserError);
    this->CloseStream();
    vtksys::SystemTools::RemoveFile(this->FileName ? this->FileName : "");
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkHexGridWriter::WriteArrayInline(
  vtkAbstractArray* array, vtkIndent indent, const char* alternateName, int writeNumTuples)
{
  if (this->IsWrittenInBlocks(array) && array->GetNumberOfComponents() == 1)
  {
    rememberRange(vtkDataArray::SafeDownCast(array));
  }
  this->Superclass::WriteArrayInline(array, indent, alternateName, writeNumTuples);
}

//------------------------------------------------------------------------------
bool vtkHexGridWriter::IsWrittenInBlocks(vtkAbstractArray* array)
{
#ifdef VTK_WORDS_BIGENDIAN
  const int own = vtkXMLWriter::BigEndian;
#else
  const int own = vtkXMLWriter::LittleEndian;
#endif
  const auto* numbers = vtkDataArray::SafeDownCast(array);
  return this->DataMode == vtkXMLWriter::Binary && this->Compressor && this->ByteOrder == own &&
    numbers && numbers->GetNumberOfValues() > 0 && numbers->HasStandardMemoryLayout() &&
    numbers->GetDataType() != VTK_BIT &&
    this->BlockSize % static_cast<std::size_t>(numbers->GetDataTypeSize()) == 0;
}

//------------------------------------------------------------------------------
void vtkHexGridWriter::WriteInlineData(vtkAbstractArray* array, vtkIndent indent)
{
  if (!this->IsWrittenInBlocks(array))
  {
    this->Superclass::WriteInlineData(array, indent);
    return;
  }
  hexsweep::BlockValues values{};
  values.data = static_cast<const unsigned char*>(array->GetVoidPointer(0));
  values.count = static_cast<std::size_t>(array->GetNumberOfValues());
  values.size = static_cast<std::size_t>(array->GetDataTypeSize());
  values.halved =
    array->GetDataType() == VTK_ID_TYPE && values.size == 8 && this->IdType == vtkXMLWriter::Int32;
  values.perBlock = this->BlockSize / values.writtenSize();
  ostream& stream = *this->Stream;
  stream << indent;
  if (!hexsweep::writeBlocks(values, this->Compressor, this->HeaderType, stream))
  {
    vtkErrorMacro("An array cannot be written: " << (array->GetName() ? array->GetName() : ""));
    this->SetErrorCode(vtkErrorCode::OutOfDiskSpaceError);
  }
  stream << "\n";
}

//------------------------------------------------------------------------------
void vtkHexGridWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
