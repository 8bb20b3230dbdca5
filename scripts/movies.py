"""Pictures to an MP4, by ffmpeg."""

import subprocess

from povray import require


class Movie:
    """Takes pictures of one size, (height, width, 3) or (height, width, 4) uint8; also a context manager.

    H.264 in yuv420p, which plays everywhere and needs even sizes: a white row or column is added where one is odd.
    """

    def __init__(self, path, rate):
        require("ffmpeg", "writes movies")
        path.parent.mkdir(parents=True, exist_ok=True)
        self.path, self.rate, self.encoder = path, rate, None

    def add(self, picture):
        if self.encoder is None:
            self.encoder = self._start(picture.shape)
        self.encoder.stdin.write(picture.tobytes())

    def __enter__(self):
        return self

    def __exit__(self, failed, *_):
        if self.encoder is None:
            return
        self.encoder.stdin.close()
        code = self.encoder.wait()
        if code and not failed:
            raise SystemExit(f"error: ffmpeg ended with {code}")

    def _start(self, shape):
        height, width, channels = shape
        command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo",
                   "-pix_fmt", {3: "rgb24", 4: "rgba"}[channels], "-s", f"{width}x{height}", "-r", f"{self.rate:g}",
                   "-i", "-", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264",
                   "-pix_fmt", "yuv420p", "-crf", "20", str(self.path)]
        return subprocess.Popen(command, stdin=subprocess.PIPE)
