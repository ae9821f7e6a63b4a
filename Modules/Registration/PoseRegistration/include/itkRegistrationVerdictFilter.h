/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef itkRegistrationVerdictFilter_h
#define itkRegistrationVerdictFilter_h

#include "itkPoseSolution.h"
#include "itkRegistrationVerdict.h"

#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"
#include "itkSize.h"

#include <vector>

namespace itk
{
/** \class RegistrationVerdictFilter
 * \brief Judges a pose registration: ok, suspect (a person should look) or failed, a jaw each, with findings.
 *
 * Input: a PoseSolution. Output: the verdicts of upper and lower jaw, decorated; a jaw without input has a verdict that
 * is ok and has no findings. The verdict of each further view is there too. RegistrationVerdict has the rules.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT RegistrationVerdictFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(RegistrationVerdictFilter);

  using Self = RegistrationVerdictFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(RegistrationVerdictFilter, ProcessObject);

  using JawEnum = ToothCode::JawEnum;
  using JawVerdictType = RegistrationVerdict::JawVerdict;
  using ThresholdsType = RegistrationVerdict::Thresholds;
  using DecoratedVerdictType = SimpleDataObjectDecorator<JawVerdictType>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** What a registration found. Must be set. */
  itkSetInputMacro(Solution, PoseSolution);
  itkGetInputMacro(Solution, PoseSolution);
  /** Limits; the defaults are what the studies of Robust.md chose. */
  void
  SetThresholds(const ThresholdsType & thresholds);
  const ThresholdsType &
  GetThresholds() const
  {
    return m_Thresholds;
  }

  /** Of the radiograph, pixels; 0 by 0 (default): unknown. A pixel spacing that only the fit tells makes a film of some
   * size of it, and no radiograph of a head is longer than RegistrationVerdict::Thresholds::failedFilmLength. */
  itkSetMacro(ImageSize, Size<2>);
  itkGetConstReferenceMacro(ImageSize, Size<2>);
  /** The verdict on a jaw. */
  DecoratedVerdictType *
  GetVerdictOutput(JawEnum jaw);
  /** Valid after Update(). */
  const JawVerdictType &
  GetVerdict(JawEnum jaw);

  /** Of a further view, by its name; throws for another name. Valid after Update(). */
  const JawVerdictType &
  GetViewVerdict(const std::string & view) const;

  /** What the data could not tell, as sentences; valid after Update(). */
  const std::vector<std::string> &
  GetNotCheckable() const
  {
    return m_NotCheckable;
  }

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  RegistrationVerdictFilter();
  ~RegistrationVerdictFilter() override = default;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  ThresholdsType           m_Thresholds;
  Size<2>                  m_ImageSize{ { 0, 0 } };
  std::vector<std::string> m_NotCheckable;

  std::map<std::string, JawVerdictType> m_ViewVerdicts;
};
} // namespace itk

#endif
