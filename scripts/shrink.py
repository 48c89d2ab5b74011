#!/usr/bin/python3
"""Write a picture small enough for a repository.

Usage: scripts/shrink.py FROM.png TO.png

At most 900 pixels wide, 256 colours.
"""
import sys

from PIL import Image


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    picture = Image.open(sys.argv[1]).convert("RGB")
    picture.thumbnail((900, 900))
    picture.quantize(256).save(sys.argv[2], optimize=True)


if __name__ == "__main__":
    main()
