"""The page that stands in the repository: scenes/FIGURES.md with pictures of modest size."""

import shutil

from PIL import Image

from plotting import ROOT

from . import page

WIDTH = 880                    # [pixels] at most
PAGE = ROOT / "scenes/FIGURES.md"
PICTURES = ROOT / "scenes/figures"


def shrink(source, folder):
    """Copies a picture at modest size: drawings as PNG of 64 colours, ray-traced ones as JPEG. Returns its name."""
    picture = Image.open(source).convert("RGB")
    if picture.width > WIDTH:
        picture = picture.resize((WIDTH, round(picture.height * WIDTH / picture.width)), Image.LANCZOS)
    if source.suffix == ".jpg":
        picture.save(folder / source.name, quality=80, optimize=True)
    else:
        picture.quantize(64, dither=Image.Dither.NONE).save(folder / source.name, optimize=True)
    return source.name


def publish(workshop, sections, machine):
    """Writes the page and its pictures; what was there goes."""
    shutil.rmtree(PICTURES, ignore_errors=True)
    PICTURES.mkdir(parents=True)
    for section in sections:
        for name, _ in section.record["outcome"].pictures if section.record else []:
            folder = PICTURES / section.figure.name
            folder.mkdir(exist_ok=True)
            shrink(workshop.folder / section.figure.name / name, folder)
    text = page.write(page.Markdown(), sections, machine, "scripts/figures", lambda figure: f"figures/{figure.name}",
                      "..")
    PAGE.write_text(text)
    size = sum(path.stat().st_size for path in [PAGE, *PICTURES.rglob("*.*")])
    workshop.say(f"{PAGE}: {size / 1e6:.2f} MB with its pictures")
