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
#include "itkTIFFPictureIO.h"

#include "itkTIFFLayoutEntry.h"

#include "itkTIFFImageIO.h"

namespace itk
{
namespace
{
IOComponentEnum
GetComponentTypeOf(const TIFFLayout & layout)
{
  switch (layout.bits)
  {
    case 8:
      return layout.isSigned ? IOComponentEnum::CHAR : IOComponentEnum::UCHAR;
    case 16:
      return layout.isSigned ? IOComponentEnum::SHORT : IOComponentEnum::USHORT;
    default:
      return layout.isSigned ? IOComponentEnum::INT : IOComponentEnum::UINT;
  }
}
} // namespace

void
TIFFPictureIO::ReadImageInformation()
{
  m_Layout = LoadTIFFReader().readLayout(this->GetFileName());
  m_ImageIO = nullptr;
  if (m_Layout && (m_Layout->IsReadAsNumbers(this->GetExpandRGBPalette()) || m_Layout->IsOfUnreadValues() ||
                   m_Layout->IsOfMoreBits()))
  {
    this->SetNumberOfDimensions(3);
    this->SetDimensions(0, m_Layout->width);
    this->SetDimensions(1, m_Layout->height);
    this->SetDimensions(2, m_Layout->pages);
    this->SetNumberOfComponents(m_Layout->samples);
    this->SetComponentType(GetComponentTypeOf(*m_Layout));
    this->SetPixelType(m_Layout->samples == 1 ? IOPixelEnum::SCALAR : IOPixelEnum::VECTOR);
  }
  else
  {
    m_ImageIO = TIFFImageIO::New().GetPointer();
    m_ImageIO->SetFileName(this->GetFileName());
    m_ImageIO->SetExpandRGBPalette(this->GetExpandRGBPalette());
    m_ImageIO->ReadImageInformation();
    this->SetNumberOfDimensions(m_ImageIO->GetNumberOfDimensions());
    for (unsigned int i = 0; i < m_ImageIO->GetNumberOfDimensions(); ++i)
    {
      this->SetDimensions(i, m_ImageIO->GetDimensions(i));
      this->SetSpacing(i, m_ImageIO->GetSpacing(i));
      this->SetOrigin(i, m_ImageIO->GetOrigin(i));
      this->SetDirection(i, m_ImageIO->GetDirection(i));
    }
    this->SetNumberOfComponents(m_ImageIO->GetNumberOfComponents());
    this->SetComponentType(m_ImageIO->GetComponentType());
    this->SetPixelType(m_ImageIO->GetPixelType());
  }
  if (m_Layout)
  {
    PutTIFFLayout(*m_Layout, this->GetMetaDataDictionary());
  }
}

void
TIFFPictureIO::Read(void * buffer)
{
  if (m_ImageIO)
  {
    m_ImageIO->SetIORegion(this->GetIORegion());
    m_ImageIO->Read(buffer);
    return;
  }
  if (!m_Layout || !m_Layout->HasNumbers() || m_Layout->pages != 1)
  {
    itkExceptionMacro("It is no TIFF of one page of whole numbers.");
  }
  LoadTIFFReader().readNumbers(this->GetFileName(), *m_Layout, static_cast<char *>(buffer));
}

void
TIFFPictureIO::Write(const void *)
{
  itkExceptionMacro("This class reads only.");
}

void
TIFFPictureIO::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Layout: " << (m_Layout ? "found" : "none") << std::endl;
  os << indent << "ImageIO: " << (m_ImageIO ? m_ImageIO->GetNameOfClass() : "none") << std::endl;
}
} // namespace itk
