"""The crowns of a lateral radiograph by SimpleITK's filters, as contours that the robust registration takes.

segmentation.py case.json folder
"""
import pathlib
import sys

import numpy as np
import SimpleITK as sitk

import dentalscr as ds

# Lengths in mm; they are sizes of teeth and not of one radiograph.
DENSE_SMOOTHING, VALLEY_WIDTH, RIDGE_WIDTH, EDGE_SMOOTHING = 0.5, 1.0, 0.6, 0.3
MARKER_OFFSET, CROWN_HEIGHT, REACH = 3.5, 7.0, 6.5


def second_derivative(image, sigma, order_u, order_v):
    orders = (sitk.RecursiveGaussianImageFilter.ZeroOrder, sitk.RecursiveGaussianImageFilter.FirstOrder,
              sitk.RecursiveGaussianImageFilter.SecondOrder)
    image = sitk.RecursiveGaussian(image, sigma, order=orders[order_u], direction=0)
    return sitk.RecursiveGaussian(image, sigma, order=orders[order_v], direction=1)


def dark_ridges(image, sigma):
    """The larger principal second derivative: high along dark lines whatever their direction."""
    uu, vv, uv = (second_derivative(image, sigma, *orders) for orders in ((2, 0), (0, 2), (1, 1)))
    half = (uu - vv) * 0.5
    return sitk.Clamp((uu + vv) * 0.5 + sitk.Sqrt(half * half + uv * uv), lowerBound=0.0)


def distance_to(mask):
    """mm to the mask's border, negative inside."""
    return sitk.SignedMaurerDistanceMap(mask, squaredDistance=False, useImageSpacing=True)


def largest_component(mask):
    return sitk.RelabelComponent(sitk.ConnectedComponent(mask), sortByObjectSize=True) == 1


def occlusal_valley(image, region):
    """The dark line between upper and lower crowns: the strongest horizontal valley within the teeth."""
    inside = sitk.Mask(sitk.Clamp(second_derivative(image, VALLEY_WIDTH, 0, 2), lowerBound=0.0), region)
    components = sitk.ConnectedComponent(sitk.OtsuThreshold(inside, region, 0, 1, 128, True, 1))
    statistics = sitk.LabelIntensityStatisticsImageFilter()
    statistics.Execute(components, inside)
    if not statistics.GetLabels():
        raise ValueError("no dark line between upper and lower crowns was found in the radiograph")
    return components == max(statistics.GetLabels(), key=statistics.GetSum)


def mask_of(array, like):
    mask = sitk.GetImageFromArray(array.astype(np.uint8))
    mask.CopyInformation(like)
    return mask


def segment_crowns(radiograph, spacing, facing):
    """Masks of the upper and lower crowns, and where the outline of each is the border of a crown."""
    image = sitk.Cast(radiograph, sitk.sitkFloat32)
    image.SetSpacing((spacing, spacing))
    image.SetOrigin((0, 0))

    # 1. The dense part of the teeth: the brightest of four classes, its largest part.
    classes = sitk.OtsuMultipleThresholds(sitk.SmoothingRecursiveGaussian(image, DENSE_SMOOTHING), numberOfThresholds=3)
    teeth = largest_component(sitk.BinaryMorphologicalOpening(classes == 3, (2, 2)))
    to_teeth = distance_to(teeth)
    region = distance_to(to_teeth <= 6.0) <= -5.0

    # 2. The valley between the jaws, and on which side of it everything lies.
    valley = occlusal_valley(image, region)
    ridges = dark_ridges(image, RIDGE_WIDTH)
    valley_array, ridge_array = sitk.GetArrayFromImage(valley) != 0, sitk.GetArrayFromImage(ridges)
    offset = round(MARKER_OFFSET / spacing)
    above, below = np.roll(valley_array, -offset, axis=0), np.roll(valley_array, offset, axis=0)
    markers = np.where(valley_array, 0, np.where(above, 1, np.where(below, 2, 0)))
    split = sitk.MorphologicalWatershedFromMarkers(
        ridges, mask_of(markers, image), markWatershedLine=False, fullyConnected=True
    )

    # 3. Where the valley ends in front, how high it lies, and how strong it is.
    rows, columns = np.nonzero(valley_array)
    front, height = (facing * columns).max(), rows.mean()
    ridge_level = np.quantile(ridge_array[valley_array], 0.3)

    # 4. Enamel fades out: what is clearly brighter than the soft tissue in front of the incisors is tooth.
    fine = sitk.SmoothingRecursiveGaussian(image, EDGE_SMOOTHING)
    v, u = np.indices(valley_array.shape)
    distance = sitk.GetArrayFromImage(to_teeth)
    tissue = sitk.GetArrayFromImage(fine)[
        (distance > 3.5) & (distance < REACH) & (facing * u > front) & (np.abs(v - height) * spacing < 8.0)
    ]
    if tissue.size < 20:
        raise ValueError("there is no soft tissue in front of the teeth to compare with; check the facing")
    level = float(tissue.mean() + 4.0 * tissue.std())
    body = largest_component(((fine >= level) & (to_teeth <= REACH)) | valley)
    body = sitk.BinaryMorphologicalClosing(body, (3, 3))

    # 5. Crowns: within a crown's height of the valley, which is prolonged to the front.
    prolonged = valley_array.copy()
    for shift in range(2, round(15.0 / spacing) + 1, 2):
        prolonged |= np.roll(valley_array, facing * shift, axis=1)
    to_valley = sitk.GetArrayFromImage(distance_to(mask_of(prolonged, image)))
    crowns = body & mask_of(to_valley <= CROWN_HEIGHT, image)

    # 6. What of the outlines is the border of a crown: in front, and for the upper crowns along the valley. The lower
    # ones end inside of the upper ones' shadow.
    edge = (
        (to_valley < CROWN_HEIGHT - 1.0)
        & (np.abs(sitk.GetArrayFromImage(distance_to(body))) < 2.0 * spacing)
        & (facing * u > front - 8.0 / spacing)
    )
    valley_border = (to_valley < CROWN_HEIGHT - 1.0) & (ridge_array > ridge_level)
    return {
        "upper": (crowns & (split == 1), mask_of(edge | valley_border, image)),
        "lower": (crowns & (split == 2), mask_of(edge, image)),
    }


def outline_of(label, mask):
    """Sub-pixel, closed, then cut to the stretches in the mask."""
    outline = ds.SilhouetteContour(label, content="MergedLabels", labelSmoothing=1.0)
    return ds.ContourMask(outline, mask, minimumNumberOfPoints=6)


def register(case, contours):
    # What one outline of both sides determines: pitch, shift and scale, not which side hangs lower.
    options = ds.PoseRegistrationOptions()
    options.useSideSelection = False
    options.useFullPose = False
    options.yawStarts = [0.0]
    options.kappaSigma = 0.008
    options.estimateNoise = False
    options.initialSmoothSigma = 2.0
    # The scans are in occlusion: one frame for both, hence one pose.
    frames = ds.UMidlineDentalAxis(case.upper, case.lower, refineMidline=True, jawsShareFrame="On")
    return ds.PoseRegistration(
        case.geometry, case.upper, contours["upper"], case.lower, contours["lower"], frames=frames, options=options
    )


def main(case_file, folder):
    case = ds.ReadCase(case_file)
    facing = 1 if case.geometry.GetFacing().name == "Right" else -1
    masks = segment_crowns(ds.to_sitk(case.image), case.geometry.GetPixelSpacing()[0], facing)
    labels = masks["upper"][0] * 128 + masks["lower"][0] * 255
    sitk.WriteImage(sitk.Cast(labels, sitk.sitkUInt8), str(folder / "labels.png"))
    contours = {jaw: outline_of(*pair) for jaw, pair in masks.items()}
    for jaw, contour in contours.items():
        print(f"{jaw} points: {contour.GetNumberOfPoints()}")
    ds.WriteContours(folder / "contours.json", case.imageSize, contours["upper"], contours["lower"])

    solution = register(case, contours)
    marked = ds.ReadLandmarks(case_file.parent / "landmarks2d.json")
    moving = {}
    for jaw in ("upper", "lower"):
        found = solution.IsRegistered(jaw)
        # Both scans have one pose: where a jaw shows too little of a border, the other one's serves.
        placed = jaw if found else "upper" if jaw == "lower" else "lower"
        letter = "U" if jaw == "upper" else "L"
        predicted = {
            name: solution.ProjectPoint(placed, point) for name, point in case.landmarks3D.items() if name[0] == letter
        }
        errors = [np.linalg.norm(predicted[name] - marked[name]) for name in predicted if name in marked]
        print(f"{jaw} landmark error px: {np.mean(errors)}")
        print(f"{jaw} verdict: {solution.GetStatus(jaw)}")
        if found:
            moving[f"{jaw} scan"] = solution.GetMovingContour(jaw)
    both = [polyline for contour in contours.values() for polyline in contour.polylines]
    picture = ds.RegistrationOverlay(case.image, both, moving, title="Outline by segmentation")
    (folder / "overlay.png").write_bytes(picture._repr_png_())


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
