# How a SPIR-V module is optimised: only passes that shrink what a driver has to read. Inlining and forwarding of locals take
# an eighth off the time that lavapipe needs to compile the renderer.
set(dead --ccp --simplify-instructions --eliminate-dead-branches --eliminate-dead-functions)
set(spirvPasses ${dead} --merge-blocks --inline-entry-points-exhaustive --eliminate-local-single-block
                --eliminate-local-single-store ${dead} --eliminate-dead-code-aggressive --merge-blocks)
