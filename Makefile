# The two commands of the README: `make demo` and `make test`. Both set up what they need.
.PHONY: setup demo test faults faults-all test-factories fuzz soak peers-cadquery speed lint clean
CARGO ?= cargo

demo: setup
	$(CARGO) build --quiet -p assemcad --bin assemcad --example demo
	./target/debug/examples/demo out

test: setup
	$(CARGO) test --quiet --workspace --no-fail-fast

# Every built-in factory at two hundred random parameter sets, and gears at all corners of their ranges.
test-factories: setup
	$(CARGO) test --quiet -p assemcad-factories --test parts -- --ignored --skip timings
	$(CARGO) test --quiet -p assemcad --test sessions the_slow_cases -- --ignored

# Sources, drafts and lines of the protocol made worse at random, for so many seconds from so many different seeds: `make fuzz SECONDS=600 SEED=7`.
SECONDS ?= 120
SEED ?= 1000000
fuzz: setup
	ASSEMCAD_FUZZ_SECONDS=$(SECONDS) ASSEMCAD_FUZZ_SEED=$(SEED) $(CARGO) test --quiet -p assemcad-script --test fuzz -- --nocapture
	ASSEMCAD_FUZZ_SECONDS=$(SECONDS) ASSEMCAD_FUZZ_SEED=$(SEED) $(CARGO) test --quiet -p assemcad --test sessions mutation

# Many clients, servers and kills, from a fixed seed: `make soak SOAK_SESSIONS=100 SOAK_SEED=7` for another. Its
# figures are in docs/soak.md.
SOAK_CLIENTS ?= 32
SOAK_SESSIONS ?= 1000
SOAK_SEED ?= 1
soak: setup
	$(CARGO) build --quiet --release -p assemcad --bin assemcad --example soak
	ASSEMCAD_LOG=error SOAK_CLIENTS=$(SOAK_CLIENTS) SOAK_SESSIONS=$(SOAK_SESSIONS) SOAK_SEED=$(SOAK_SEED) ./target/release/examples/soak

# The language held against CadQuery itself, in a Python environment of its own: the scripts keep to what
# both have, CadQuery still gives what is recorded, and so does the language.
PEERS = tests/cadquery
peers-cadquery: setup
	python3 -m venv $(PEERS)/.venv
	$(PEERS)/.venv/bin/pip install --quiet -r $(PEERS)/requirements.txt
	$(PEERS)/.venv/bin/python $(PEERS)/coverage.py
	$(PEERS)/.venv/bin/python $(PEERS)/golden.py --check
	$(CARGO) test --quiet -p assemcad-factories --test cadquery -- --nocapture

# The server and CadQuery on the same assemblies, one after the other: docs/speed.md. Best on a machine that has
# nothing else to do: `make speed SPEED='--sizes 18,50 --machines gears'` for some of it.
SPEED =
speed: setup
	python3 -m venv bench/speed/.venv
	bench/speed/.venv/bin/pip install --quiet -r $(PEERS)/requirements.txt
	$(CARGO) build --quiet --release -p assemcad --bin assemcad
	bench/speed/.venv/bin/python bench/speed/run.py $(SPEED)

# Sound assemblies and what was broken in each, all before a server: docs/faults.md.
faults: setup
	$(CARGO) build --quiet -p assemcad --bin assemcad --example faults
	./target/debug/examples/faults

# The larger suite, about five hundred cases, from outside over the protocol; it needs python3 with PyYAML.
faults-all: setup
	$(CARGO) build --quiet --release -p assemcad --bin assemcad
	python3 tests/defects/run.py --bin target/release/assemcad --jobs 2

setup:
	@scripts/setup

lint: setup
	$(CARGO) fmt --all --check
	$(CARGO) clippy --quiet --workspace --all-targets -- -D warnings

clean:
	$(CARGO) clean
	rm -rf out .occt .cargo/config.toml
