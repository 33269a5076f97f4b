# SPDX-License-Identifier: MIT
# Runs the README's two commands on a bare Debian:  docker build -t osgtreewind . && docker run --rm osgtreewind
# For another release:  docker build --build-arg RELEASE=trixie -t osgtreewind .     (bookworm, trixie, testing)
# The image has the demo's pictures and clip in /osgTreeWind/build/demo; a run of it runs the tests.
ARG RELEASE=bookworm
FROM debian:$RELEASE
RUN apt-get update && apt-get install -y --no-install-recommends git ca-certificates
COPY . /osgTreeWind
WORKDIR /osgTreeWind
RUN script/demo
CMD ["script/test"]
