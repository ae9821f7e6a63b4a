"""Reads the transform files that the program writes, without ITK."""
import math


def read_transform(path):
    """An ITK transform file as a function of a point, by the definitions of ITK's software guide: R (p - c) + c + t."""
    lines = dict(line.split(": ", 1) for line in path.read_text().splitlines() if ": " in line and not line.startswith("#"))
    parameters = [float(number) for number in lines["Parameters"].split()]
    center = [float(number) for number in lines["FixedParameters"].split()]
    if lines["Transform"].startswith("VersorRigid3DTransform"):
        # The right part of a unit quaternion, then the translation. It turns p to q p q*.
        x, y, z = parameters[:3]
        w = math.sqrt(1.0 - x * x - y * y - z * z)

        def multiply(a, b):
            return (
                a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
                a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
                a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
                a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
            )

        def turn(p):
            return multiply(multiply((w, x, y, z), (0.0, *p)), (w, -x, -y, -z))[1:]

        translation = parameters[3:6]
    else:
        assert lines["Transform"].startswith("Similarity2DTransform")
        scale, angle = parameters[:2]

        def turn(p):
            c, s = scale * math.cos(angle), scale * math.sin(angle)
            return c * p[0] - s * p[1], s * p[0] + c * p[1]

        translation = parameters[2:4]

    def apply(p):
        turned = turn([a - b for a, b in zip(p, center)])
        return tuple(a + b + c for a, b, c in zip(turned, center, translation))

    return apply


def is_anatomical(place, jaw):
    """Whether landmarks lie as x anterior, y to the patient's left and z superior say: molars at the sides and behind, incisal edges
    towards the other jaw."""
    right, left, front = place[f"{jaw}R6_MB"], place[f"{jaw}L6_MB"], place[f"{jaw}R1_tip"]
    towards = -1.0 if jaw == "U" else 1.0
    return right[1] < -10 and left[1] > 10 and front[0] > right[0] + 10 and towards * front[2] > 0
