(define (problem test-17)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 - block)
  (:init
    (hand-empty) (on-table b5) (clear b2) (on b1 b5) (on b3 b1) (on b4 b3)
    (on b2 b4))
  (:goal (and
    (on b2 b3) (on b4 b2) (on b1 b5))))
