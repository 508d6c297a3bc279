// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADRun.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>

namespace hexsweep
{
Standard_Boolean CADProgress::UserBreak()
{
  return this->Stopped;
}

void CADProgress::Show(const Message_ProgressScope&, const Standard_Boolean)
{
  if (!this->Stopped && this->Told && !this->Told(this->GetPosition()))
  {
    this->Stopped = true;
  }
}

SilencedCAD::SilencedCAD()
{
  Message_SequenceOfPrinters& printers = Message::DefaultMessenger()->ChangePrinters();
  this->Printers = printers;
  printers.Clear();
}

SilencedCAD::~SilencedCAD()
{
  Message::DefaultMessenger()->ChangePrinters() = this->Printers;
}

std::string describeFailure(const Standard_Failure& failure)
{
  const std::string said = failure.GetMessageString() ? failure.GetMessageString() : "";
  const std::string kind = failure.DynamicType()->Name();
  return said.empty() ? kind : kind + ", " + said;
}
}
