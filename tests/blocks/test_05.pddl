(define (problem test-05)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 - block)
  (:init
    (hand-empty) (on-table b4) (on-table b3) (on-table b1) (on-table b2)
    (clear b4) (clear b3) (clear b5) (clear b2) (on b5 b1))
  (:goal (and
    (on b2 b1) (on b3 b2) (on b4 b5))))
