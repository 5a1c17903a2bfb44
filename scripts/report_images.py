"""The pictures that runs left, and what tells two of one scene apart, computed from the linear values of the EXR files.

A run writes a scene's picture as SCENE.exr and .png, and as SCENE--CONTENDER likewise what other contenders made of it.
"""

import base64
import io

import numpy
from PIL import Image, UnidentifiedImageError

from difference_colours import difference_colours
from plot_inputs import InputError
from report_html import join, tag

try:
    import OpenImageIO
except ImportError:
    OpenImageIO = None

WIDTHS = [800, 640, 480, 320, 200]  # in pixels; the first by which all pictures of a page fit
MOST_BYTES = 4_000_000  # of all pictures, as PNG


class Picture:
    def __init__(self, run, path):
        self.path, self.exr = path, path.with_suffix(".exr")
        self.scene, _, contender = path.stem.partition("--")
        self.name = f"{self.scene}, {contender or 'first contender'}, {run.name}"
        try:
            with Image.open(path) as image:
                self.image = image.convert("RGB")
        except (OSError, UnidentifiedImageError, SyntaxError) as error:
            raise InputError(f"{path}: cannot be read: {error}; run the experiment again, or remove the file") from None

    def linear(self):
        found = numpy.asarray(OpenImageIO.ImageBuf(str(self.exr)).get_pixels(OpenImageIO.FLOAT))  # empty if it cannot
        if found.ndim != 3 or found.shape[:2] != self.image.size[::-1]:
            raise InputError(f"{self.exr}: cannot be read, or is not of the size of {self.path.name}; run the "
                             "experiment again, or remove the file")
        return found[..., :3].astype(numpy.float64)


def pictures_of(run):
    """Each scene's first contender first; charts, which are PNG alone, are none."""
    paths = [path for path in run.folder.glob("*.png") if path.with_suffix(".exr").exists()]
    return [Picture(run, path) for path in sorted(paths, key=lambda path: path.stem.partition("--"))]


class Difference:
    """Of one picture from the first of its scene; `image` is None where there is none to see."""

    def __init__(self, first, other):
        a, b = first.linear(), other.linear()
        self.first, self.other, self.image = first, other, None
        difference = (b - a).mean(axis=2)
        if (a == b).all():
            self.said = "The same bit for bit."
            return
        if not numpy.isfinite(difference).all():
            self.said = "A picture holds values that are not finite; there is no difference to show."
            return
        colours, scale = difference_colours(difference)
        self.image = Image.fromarray(numpy.uint8(255 * colours + 0.5))
        mean = max(a.mean(), 1e-30)
        pixels = (a != b).any(axis=2).mean()
        self.said = (f"Orange where it is brighter, blue where darker; full colour is {scale:.3g} (linear, mean of the "
                     f"channels; the mean of the picture is {mean:.3g}). {100 * pixels:.3g} % of the pixels differ, on the "
                     f"whole by {100 * difference.mean() / mean:+.2g} %, root of the mean square "
                     f"{100 * (difference ** 2).mean() ** 0.5 / mean:.2g} % of the mean.")


def differences(pictures):
    first_of, found = {}, []
    for picture in pictures:
        first = first_of.setdefault((picture.scene, picture.image.size), picture)
        if first is not picture:
            found.append(Difference(first, picture))
    return found


def encode(image, width):
    if image.width > width:
        image = image.resize((width, max(1, round(image.height * width / image.width))), Image.Resampling.BOX)
    data = io.BytesIO()
    image.save(data, "PNG", optimize=True)
    return image.size, data.getvalue()


def shrink(images):
    """(size, bytes) of each, all by one width; at the smallest, None for those that have no room left."""
    for width in WIDTHS:
        encoded = [encode(image, width) for image in images]
        if sum(len(data) for _, data in encoded) <= MOST_BYTES:
            return encoded
    total, kept = 0, []
    for size, data in encoded:
        total += len(data)
        kept.append((size, data) if total <= MOST_BYTES else None)
    return kept


def shown(encoded, alt, caption, original):
    if encoded is None:
        return tag("p", f"{caption} Left out, since the page is full; the picture is {original}.")
    (width, height), data = encoded
    source = "data:image/png;base64," + base64.b64encode(data).decode()
    return tag("figure", tag("img", src=source, alt=alt, width=width, height=height, class_="picture"),
               tag("figcaption", caption))


def gallery(runs):
    """All pictures of the page, each scene's differences after it; None where no run has any."""
    pictures = [picture for run in runs for picture in pictures_of(run)]
    if not pictures:
        return None
    content, told = [], differences(pictures) if OpenImageIO else []
    if not OpenImageIO and len({picture.scene for picture in pictures}) < len(pictures):
        content.append(tag("p", tag("strong", "Note: "), "no difference images, since this Python cannot read EXR; "
                           "apt-get install python3-openimageio"))
    seen = [difference for difference in told if difference.image]
    encoded = shrink([picture.image for picture in pictures] + [difference.image for difference in seen])
    for picture, image in zip(pictures, encoded):
        content.append(shown(image, f"Rendered picture: {picture.name}",
                             f"{picture.name}, {picture.image.width}x{picture.image.height} pixels.", picture.path))
    drawn = dict(zip(map(id, seen), encoded[len(pictures):]))
    for difference in told:
        title = f"{difference.other.name} minus {difference.first.name}: "
        if difference.image:
            content.append(shown(drawn[id(difference)], "Difference image: " + title + difference.said,
                                 title + difference.said, difference.other.exr))
        else:
            content.append(tag("p", title + difference.said))
    return join([tag("div", *content, class_="pictures")])
