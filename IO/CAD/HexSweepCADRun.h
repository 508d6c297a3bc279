// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How the CAD kernel is called: its progress, its messages, its exceptions. Private to the
 * module.
 */
#ifndef HexSweepCADRun_h
#define HexSweepCADRun_h

#include "Core/Common/Errors.h"

#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressRange.hxx>
#include <Message_SequenceOfPrinters.hxx>
#include <Standard_Failure.hxx>

#include <string>
#include <utility>

namespace hexsweep
{
/// The kernel's progress told to Core's. A progress that says no makes the kernel stop.
class CADProgress : public Message_ProgressIndicator
{
  DEFINE_STANDARD_RTTI_INLINE(CADProgress, Message_ProgressIndicator)

public:
  explicit CADProgress(Progress progress)
    : Told(std::move(progress))
  {
  }

  /// To be called after each step of the kernel. @throw Aborted.
  void check() const
  {
    if (this->Stopped)
    {
      throw Aborted();
    }
  }

protected:
  Standard_Boolean UserBreak() override;
  void Show(const Message_ProgressScope& scope, const Standard_Boolean isForced) override;

private:
  Progress Told;
  bool Stopped = false;
};

/// The kernel prints to standard output; within the life of this object it does not.
class SilencedCAD
{
public:
  SilencedCAD();
  ~SilencedCAD();
  SilencedCAD(const SilencedCAD&) = delete;
  SilencedCAD& operator=(const SilencedCAD&) = delete;

private:
  Message_SequenceOfPrinters Printers;
};

/// What the kernel says of a failure, in one line.
std::string describeFailure(const Standard_Failure& failure);

/// Runs a step of the kernel. @throw InvalidInput with `what` before the kernel's words where it
/// throws.
template <typename Call>
auto callCAD(const std::string& what, Call&& call)
{
  try
  {
    return call();
  }
  catch (const Standard_Failure& failure)
  {
    throw InvalidInput(what + ": " + describeFailure(failure) + ".");
  }
}
}

#endif
