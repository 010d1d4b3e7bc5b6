"""Reduces a figure for a document: at most 1100 pixels wide, 48 colours.

    small_picture.py FROM.png TO.png
"""

import sys

from PIL import Image

WIDTH, COLOURS = 1100, 48

picture = Image.open(sys.argv[1]).convert("RGB")
if picture.width > WIDTH:
    height = round(picture.height * WIDTH / picture.width)
    picture = picture.resize((WIDTH, height), Image.LANCZOS)
picture.quantize(COLOURS, dither=Image.Dither.NONE).save(sys.argv[2], optimize=True)
