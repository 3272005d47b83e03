#!/usr/bin/env python3
"""Serves a folder at a local address with the headers that threads in WebAssembly need: serve.py FOLDER [PORT]."""

import functools
import http.server
import sys


class Page(http.server.SimpleHTTPRequestHandler):
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map,
                      ".wasm": "application/wasm", ".js": "text/javascript", ".data": "application/octet-stream"}

    def end_headers(self):
        self.send_header("Cross-Origin-Opener-Policy", "same-origin")
        self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        self.send_header("Cache-Control", "no-cache")
        super().end_headers()

    def log_message(self, *_):
        pass


def main():
    folder, port = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 8017
    handler = functools.partial(Page, directory=folder)
    for tried in range(port, port + 20):
        try:
            server = http.server.ThreadingHTTPServer(("127.0.0.1", tried), handler)
            break
        except OSError:  # another program's
            continue
    else:
        sys.exit(f"no port from {port} to {port + 19} is free")
    print(f"Weftlight is at http://localhost:{server.server_address[1]}/  (Ctrl+C ends)", flush=True)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
