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
#ifndef itkTracedSideFilter_h
#define itkTracedSideFilter_h

#include "PoseRegistrationExport.h"

#include "itkCephalometricLandmarkSet.h"
#include "itkDentalContour.h"
#include "itkProcessObject.h"
#include "itkTracedSide.h"

#include <vector>

namespace itk
{
/** \class TracedSideFilter
 * \brief Which side's outlines a drawing shows, where nobody says it, and the drawing without the other side's.
 *
 * A registration compares a tracing with the outline of one side of the jaws, of both, or of the middle between them,
 * and has to be told which (PoseRegistrationOptions::tracedSide). Where TracedSideIsGiven is on, TracedSide is taken at
 * its word. Else the drawing is asked: landmarks without a tracing are of the sides that their names say, or those of a
 * cephalometric analysis (Standard); codes without a side (CodesHaveSides off), and closed outlines of incisors and
 * molars of one side each whose incisors have their roots, are a standard tracing; at least two teeth behind the
 * lateral incisors that are drawn of both sides make it Both. Where nothing tells, TracedSide stays.
 *
 * Inputs, each optional: upper and lower contour, landmarks of a cephalometric analysis.
 *
 * Outputs: the contours, without the teeth of the other side where one side was traced and those teeth are drawn of
 * both: they have no outline to lie on. GetSettledSide(), GetReason() and GetLeftOutTeeth() say what was decided.
 *
 * \test itkTracedSideFilterGTest.cxx
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT TracedSideFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TracedSideFilter);

  using Self = TracedSideFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(TracedSideFilter, ProcessObject);

  using ContourType = DentalContour;
  using LandmarksType = CephalometricLandmarkSet;
  using JawEnum = ToothCode::JawEnum;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  /** What the settled side was decided by. */
  enum class ReasonEnum : uint8_t
  {
    /** TracedSideIsGiven is on. */
    Given,
    /** Nothing in the drawing tells: TracedSide as it is set. */
    Nothing,
    /** There is no tracing, and every landmark's name says its side. */
    SidesOfLandmarks,
    /** There is no tracing, and landmarks do not all say their side. */
    LandmarksAlone,
    /** Codes of the tracing do not say their side. */
    SidelessCodes,
    /** Whole incisors and molars alone are traced. */
    WholeTeeth,
    /** Teeth of both sides are traced. */
    TeethOfBothSides
  };
  /** The drawing, continuous pixel indices; each may be missing. */
  itkSetInputMacro(UpperContour, ContourType);
  itkGetInputMacro(UpperContour, ContourType);
  itkSetInputMacro(LowerContour, ContourType);
  itkGetInputMacro(LowerContour, ContourType);
  itkSetInputMacro(CephalometricLandmarks, LandmarksType);
  itkGetInputMacro(CephalometricLandmarks, LandmarksType);

  /** What is said of the drawing, or taken where nothing tells. Default Right. */
  itkSetEnumMacro(TracedSide, TracedSideEnum);
  itkGetEnumMacro(TracedSide, TracedSideEnum);

  /** Whether TracedSide was said by somebody. Default off. */
  itkSetMacro(TracedSideIsGiven, bool);
  itkGetConstMacro(TracedSideIsGiven, bool);
  itkBooleanMacro(TracedSideIsGiven);

  /** Off: codes such as U1 and L6 were read as those of the right side (DentalContourFileReader). Default on. */
  itkSetMacro(CodesHaveSides, bool);
  itkGetConstMacro(CodesHaveSides, bool);
  itkBooleanMacro(CodesHaveSides);
  /** The drawing of a jaw, without the outlines of the side that is not registered to. */
  ContourType *
  GetOutput(JawEnum jaw);
  ContourType *
  GetUpperOutput()
  {
    return this->GetOutput(JawEnum::Upper);
  }
  ContourType *
  GetLowerOutput()
  {
    return this->GetOutput(JawEnum::Lower);
  }

  /** Valid after Update(). */
  TracedSideEnum
  GetSettledSide() const
  {
    return m_SettledSide;
  }
  ReasonEnum
  GetReason() const
  {
    return m_Reason;
  }
  /** The other side's teeth that are in no output, in the order of the drawing; one for each polyline. */
  const std::vector<ToothCode> &
  GetLeftOutTeeth() const
  {
    return m_LeftOutTeeth;
  }

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  TracedSideFilter();
  ~TracedSideFilter() override = default;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  const ContourType *
  GetContour(JawEnum jaw) const;
  /** From the drawing; sets the reason. */
  TracedSideEnum
  ReadSide();
  void
  LeaveOutOtherSide(JawEnum jaw);

  TracedSideEnum m_TracedSide{ TracedSideEnum::Right };
  bool           m_TracedSideIsGiven{ false };
  bool           m_CodesHaveSides{ true };

  TracedSideEnum         m_SettledSide{ TracedSideEnum::Right };
  ReasonEnum             m_Reason{ ReasonEnum::Nothing };
  std::vector<ToothCode> m_LeftOutTeeth;
};

/** A clause for a message: "whole incisors and molars alone are traced". \ingroup PoseRegistration */
PoseRegistration_EXPORT const char *
                        ToString(TracedSideFilter::ReasonEnum reason);
PoseRegistration_EXPORT std::ostream &
                        operator<<(std::ostream & os, TracedSideFilter::ReasonEnum reason);
} // namespace itk

#endif
