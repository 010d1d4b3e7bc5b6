"""Ctrl-C during solve() and the functionals: KeyboardInterrupt within a second, and later calls work.

    interruption_test.py        with the package on PYTHONPATH
"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import fpkcheck as fpk


class Interruption(unittest.TestCase):
    def interrupt(self, after, call):
        """Seconds from the signal to KeyboardInterrupt, and whether the call had ended before the signal."""
        sent = []

        def send():
            time.sleep(after)
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=send)
        ended = False
        try:
            thread.start()
            call()
            ended = True
            thread.join()
            time.sleep(1)
            self.fail("no KeyboardInterrupt")
        except KeyboardInterrupt:
            answered = time.monotonic()
        return answered - sent[0], ended

    def test_raises_within_a_second_and_later_calls_work(self):
        for methods, options in (
            ("mcs", {"mcs.time": 1e9}),
            ("fd-kf", {"fd.nx": 200, "fd.nv": 400}),
            ("epc,fd,mcs", {}),
        ):
            late, ended = self.interrupt(0.3, lambda: fpk.solve("case2", methods, options=options))
            self.assertLess(late, 1, methods)
            self.assertFalse(ended, methods)
            again = fpk.solve("case1", "fd-white", bounds=False)
            self.assertEqual(again.solutions["fd-white"].status, "ok")

    def test_of_functionals_raises_within_a_second(self):
        for call in (
            lambda: fpk.passage("case1", displacement=3, methods="mcs", time=1e9),
            lambda: fpk.spectrum("case4", methods="fd", accuracy=1e-9, max_seconds=10),
        ):
            late, ended = self.interrupt(0.3, call)
            self.assertLess(late, 1)
            self.assertFalse(ended)

    def test_of_saving_leaves_complete_files(self):
        run = fpk.solve("case1", "fd-white,epc-moment-n4", bounds=False)
        with tempfile.TemporaryDirectory() as folder:
            directory = pathlib.Path(folder, "run")
            late, _ = self.interrupt(0.1, lambda: run.save(directory))
            self.assertLess(late, 1)
            self.assertEqual(fpk.load(directory).solutions, run.solutions)
            run.save(directory)
            self.assertTrue((directory / "figures" / "case1.png").exists())

    def test_the_process_may_end_before_abandoned_threads(self):
        program = """if True:
            import os, signal, threading, fpkcheck
            threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
            try:
                fpkcheck.solve("case2", "fd-kf", options={"fd.nx": 200, "fd.nv": 400})
            except KeyboardInterrupt:
                print("interrupted")
            raise SystemExit(3)
            """
        begin = time.monotonic()
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
        self.assertEqual((done.returncode, done.stdout), (3, "interrupted\n"), done.stderr)
        self.assertLess(time.monotonic() - begin, 3)


if __name__ == "__main__":
    unittest.main()
