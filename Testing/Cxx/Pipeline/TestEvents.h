// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Collects what a filter and its executive say, instead of printing it.
 */
#ifndef TestEvents_h
#define TestEvents_h

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace test
{
/// Errors and warnings of one algorithm. Must not outlive it.
class Events
{
public:
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
  /// A missing input, and the note that a request failed, which follows every error of a filter
  /// (and is displayed only where somebody else fails).
  std::vector<std::string> executiveErrors;

  explicit Events(vtkAlgorithm* algorithm)
  {
    this->watch(algorithm, vtkCommand::ErrorEvent, this->errors);
    this->watch(algorithm, vtkCommand::WarningEvent, this->warnings);
    this->watch(algorithm->GetExecutive(), vtkCommand::ErrorEvent, this->executiveErrors);
  }
  ~Events()
  {
    for (EventCollector* collector : this->Collectors)
    {
      collector->Texts = nullptr;
    }
  }
  Events(const Events&) = delete;
  void operator=(const Events&) = delete;

private:
  class EventCollector : public vtkCommand
  {
  public:
    static EventCollector* New() { return new EventCollector; }
    std::vector<std::string>* Texts = nullptr;

    void Execute(vtkObject*, unsigned long, void* text) override
    {
      if (this->Texts)
      {
        this->Texts->emplace_back(static_cast<const char*>(text));
      }
    }
  };

  void watch(vtkObject* object, unsigned long event, std::vector<std::string>& texts)
  {
    vtkSmartPointer<EventCollector> collector = vtkSmartPointer<EventCollector>::New();
    collector->Texts = &texts;
    object->AddObserver(event, collector);
    this->Collectors.push_back(collector);
  }

  std::vector<vtkSmartPointer<EventCollector>> Collectors;
};
}

#endif
